#include "apps/other_programs.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "apps/checker_path.hpp"

namespace delcert {

CLI::App* add_named(CLI::App& program, const CommandName& command) {
  return program.add_subcommand(command.name, command.description);
}

void hand_over_to(const OtherProgram& other) {
  namespace fs = std::filesystem;
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / other.name;
  if (first_executable({program}).empty())
    throw std::runtime_error(program.string() + " is not there, and " + other.part +
                             " are its part; in the source tree ./run builds it");
  std::ifstream stream("/proc/self/cmdline", std::ios::binary);
  std::string words((std::istreambuf_iterator<char>(stream)), {});
  std::vector<char*> pointers;
  for (std::size_t at = 0; at < words.size(); at = words.find('\0', at) + 1) pointers.push_back(words.data() + at);
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  throw std::system_error(errno, std::generic_category(), "cannot run " + program.string());
}

}  // namespace delcert
