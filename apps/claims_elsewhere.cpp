// A part of delcert-certify and delcert-publish, not of delcert-claims: of the subcommands about claims they have the
// names only.

#include "apps/other_programs.hpp"

namespace delcert {

bool is_left_to_claims(std::string_view subcommand) { return is_among(claim_commands, subcommand); }

// Never parsed: main hands over before.
void add_claims(CLI::App& program, Action&) { add_named(program, about_claims); }
void add_attack(CLI::App& program, Action&) { add_named(program, about_attack); }
void add_campaign(CLI::App& program, Action&) { add_named(program, about_campaign); }
void add_tighten(CLI::App& program, Action&) { add_named(program, about_tighten); }
void add_power(CLI::App& program, Action&) { add_named(program, about_power); }
void add_prove(CLI::App& program, Action&) { add_named(program, about_prove); }
void add_errata(CLI::App& program, Action&) { add_named(program, about_errata); }
void add_tables(CLI::App& program, Action&) { add_named(program, about_tables); }
void add_formalise(CLI::App& program, Action&) { add_named(program, about_formalise); }

}  // namespace delcert
