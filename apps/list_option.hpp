#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// The most values that a list may have.
inline constexpr std::size_t longest_list = 1000;

/// An option whose value is a list of exact numbers, "1/4,1/2,1". An empty part, a word that is no number, one that is
/// listed twice (1/2 and 2/4 are one number) and more than longest_list of them are usage errors that say what is
/// wrong.
CLI::Option* add_exact_list_option(CLI::App& command, const std::string& name, std::vector<Rational>& values,
                                   const std::string& help);

/// The same for integers and ranges of integers, "2", "2..6", "1,3..5"; a range whose end is below its beginning is an
/// error too.
CLI::Option* add_integer_list_option(CLI::App& command, const std::string& name, std::vector<int>& values,
                                     const std::string& help);

}  // namespace delcert
