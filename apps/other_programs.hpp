#pragma once

#include <string_view>

#include "apps/commands.hpp"
#include "apps/program_names.hpp"

namespace delcert {

/// Adds it as `program` has it.
CLI::App* add_named(CLI::App& program, const CommandName& command);

/// Whether this program leaves the subcommand to delcert-publish. That program and delcert-claims never do.
[[nodiscard]] bool is_left_to_publishing(std::string_view subcommand);
/// Whether this program leaves the subcommand to delcert-claims. That program never does.
[[nodiscard]] bool is_left_to_claims(std::string_view subcommand);

/// Replaces this process by that program of the same folder, with the same arguments. Returns only by throwing:
/// std::runtime_error if it is not there, std::system_error if it cannot be run.
[[noreturn]] void hand_over_to(const OtherProgram& program);

}  // namespace delcert
