#pragma once

#include <CLI/CLI.hpp>
#include <set>
#include <string>

namespace delcert {

/// The subcommand as it was called, with the long names of options, in the order of its help and without those that are
/// left out; values are quoted for a shell where they have to be. Precondition: the command line has been read.
[[nodiscard]] std::string command_line(const std::string& program, const CLI::App& subcommand,
                                       const std::set<std::string>& left_out);

/// The word as a POSIX shell reads it back: in single quotes unless all its characters are harmless.
[[nodiscard]] std::string shell_word(const std::string& word);

}  // namespace delcert
