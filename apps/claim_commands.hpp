#pragma once

#include <string_view>

#include "apps/commands.hpp"

namespace delcert {

/// A subcommand by its name and the line that --help has of it.
struct CommandName {
  const char* name;
  const char* description;
};

/// The subcommands about claims and proofs. Only the program delcert-claims, which is delcert with all of its parts,
/// can do them; delcert itself, which is built in half the time, knows their names and hands over.
inline constexpr CommandName about_claims{"claims", "The claims of the library, and what claims can speak of"};
inline constexpr CommandName about_attack{"attack", "Attack claims on random instances, with exact decisions"};
inline constexpr CommandName about_campaign{"campaign",
                                            "Merge the parts of long attacks, show how far they are, recheck them"};
inline constexpr CommandName about_tighten{"tighten", "Search for the instances that come nearest to refuting a claim"};
inline constexpr CommandName about_prove{"prove", "Prove the numeric steps of claims for all parameters"};
inline constexpr CommandName about_errata{
    "errata", "Print remarks on the preprint of the paper, with commands that reproduce them"};
inline constexpr CommandName about_tables{
    "tables", "Print the constants of the lemmas: the paper's, provable by the same proof, shown necessary"};
inline constexpr CommandName about_formalise{"formalise", "Write the steps of proofs as files for Coq"};

/// Adds it as `program` has it.
inline CLI::App* add_named(CLI::App& program, const CommandName& command) {
  return program.add_subcommand(command.name, command.description);
}

/// Whether this program leaves the subcommand to delcert-claims. In delcert-claims itself it never does.
[[nodiscard]] bool is_left_to_claims(std::string_view subcommand);

/// Replaces this process by the delcert-claims beside it, with the same arguments. Returns only by throwing:
/// std::runtime_error if it is not there, std::system_error if it cannot be run.
[[noreturn]] void hand_over_to_claims();

}  // namespace delcert
