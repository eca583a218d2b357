#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "kernel/number/rational.hpp"

namespace delcert {

/// An option whose value is an exact number: an integer, p/q or a hexadecimal float. Anything else is a usage error
/// that says how to write it.
CLI::Option* add_exact_option(CLI::App& command, const std::string& name, Rational& value, const std::string& help);

/// The same for a value that need not be given.
CLI::Option* add_exact_option(CLI::App& command, const std::string& name, std::optional<Rational>& value,
                              const std::string& help);

}  // namespace delcert
