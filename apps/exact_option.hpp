#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "kernel/number/rational.hpp"

namespace delcert {

/// An option whose value is an exact number: an integer, p/q or a hexadecimal float. Anything else is a usage error
/// that says how to write it. A default is shown in the help.
CLI::Option* add_exact_option(CLI::App& command, const std::string& name, Rational& value, const std::string& help);

}  // namespace delcert
