#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "apps/checker_path.hpp"
#include "apps/claim_commands.hpp"

namespace delcert {

void hand_over_to_claims() {
  namespace fs = std::filesystem;
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "delcert-claims";
  if (first_executable({program}).empty())
    throw std::runtime_error(program.string() +
                             " is not there, and claims are its part; in the source tree ./run builds it");
  std::ifstream stream("/proc/self/cmdline", std::ios::binary);
  std::string words((std::istreambuf_iterator<char>(stream)), {});
  std::vector<char*> pointers;
  for (std::size_t at = 0; at < words.size(); at = words.find('\0', at) + 1) pointers.push_back(words.data() + at);
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  throw std::system_error(errno, std::generic_category(), "cannot run " + program.string());
}

}  // namespace delcert
