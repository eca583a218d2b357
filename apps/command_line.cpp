#include "apps/command_line.hpp"

namespace delcert {

std::string shell_word(const std::string& word) {
  constexpr const char* harmless = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_@%+=:,./-";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

std::string command_line(const std::string& program, const CLI::App& subcommand,
                         const std::set<std::string>& left_out) {
  std::string line = program + " " + subcommand.get_name();
  for (const CLI::Option* option : subcommand.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || left_out.contains(name)) continue;
    if (name.starts_with('-')) line += " " + name;
    if (option->get_items_expected_max() == 0) continue;
    for (const std::string& value : option->results()) line += " " + shell_word(value);
  }
  return line;
}

}  // namespace delcert
