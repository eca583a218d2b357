#pragma once

#include <span>

#include "apps/commands.hpp"

namespace delcert {

/// Reads the arguments of a program and runs the subcommand that they call for. It is all of main() but the list of
/// subcommands, and is in the library, where it is compiled together with what else reads arguments.
[[nodiscard]] ExitStatus run_program(int argc, char** argv, std::span<const AddCommand> commands);

}  // namespace delcert
