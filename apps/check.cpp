#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <system_error>

#include "apps/checker_process.hpp"
#include "apps/commands.hpp"

namespace delcert {

void run_checker(const std::vector<std::string>& arguments) {
  const std::filesystem::path checker = installed_checker();
  std::vector<std::string> words{checker.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(checker.c_str(), pointers.data());
  throw std::system_error(errno, std::generic_category(), "cannot run " + checker.string());
}

void add_check(CLI::App& program, Action&) {
  // Never parsed but for its help: main hands the arguments to the checker as they are.
  CLI::App* command = program.add_subcommand("check", "Verify a certificate with the separate checker, delcert-check");
  command->add_option("FILE", "Certificates, plain or compressed; options as in delcert-check --help")->required();
  command->footer(
      "Runs delcert-check, a program that shares no code with this one, with the same arguments, and ends with its\n"
      "exit status: 0 verified, 1 a check failed, 2 undecided, 3 malformed, 64 usage, 70 internal.\n\n"
      "Examples:\n"
      "  delcert check certificates/torus-3.json.zst\n"
      "  delcert check --help        prints this page\n"
      "  delcert-check --help        prints the checker's own options");
}

}  // namespace delcert
