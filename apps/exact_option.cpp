#include "apps/exact_option.hpp"

#include <CLI/CLI.hpp>

#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {

template <class Target>
CLI::Option* add_option(CLI::App& command, const std::string& name, Target& value, const std::string& help) {
  const auto read = [&value, name](const std::string& text) {
    try {
      value = parse_exact(text);
    } catch (const ExactTextError& error) {
      throw CLI::ValidationError(name, error.what());
    }
  };
  return command.add_option_function<std::string>(name, read, help)->type_name("NUMBER");
}

}  // namespace

CLI::Option* add_exact_option(CLI::App& command, const std::string& name, Rational& value, const std::string& help) {
  return add_option(command, name, value, help);
}

CLI::Option* add_exact_option(CLI::App& command, const std::string& name, std::optional<Rational>& value,
                              const std::string& help) {
  return add_option(command, name, value, help);
}

}  // namespace delcert
