#pragma once

#include <string>
#include <vector>

#include "apps/exit_status.hpp"

namespace CLI {
class App;
}

namespace delcert {

/// Adds one subcommand: its options, its help with examples, and a callback that sets `chosen` to what is to be done
/// once the command line has been read. A new subcommand is a file, a line here and a line in main.cpp.
using AddCommand = void (*)(CLI::App& program, Action& chosen);

void add_constants(CLI::App& program, Action& chosen);
void add_sample(CLI::App& program, Action& chosen);
void add_certify(CLI::App& program, Action& chosen);
void add_check(CLI::App& program, Action& chosen);
void add_split(CLI::App& program, Action& chosen);
void add_info(CLI::App& program, Action& chosen);
void add_cite(CLI::App& program, Action& chosen);
void add_figure(CLI::App& program, Action& chosen);
void add_bundle(CLI::App& program, Action& chosen);
void add_manifolds(CLI::App& program, Action& chosen);
void add_homology(CLI::App& program, Action& chosen);
void add_export(CLI::App& program, Action& chosen);
void add_claims(CLI::App& program, Action& chosen);
void add_attack(CLI::App& program, Action& chosen);
void add_campaign(CLI::App& program, Action& chosen);
void add_tighten(CLI::App& program, Action& chosen);
void add_power(CLI::App& program, Action& chosen);
void add_formalise(CLI::App& program, Action& chosen);
void add_prove(CLI::App& program, Action& chosen);
void add_errata(CLI::App& program, Action& chosen);
void add_tables(CLI::App& program, Action& chosen);
void add_report(CLI::App& program, Action& chosen);

/// Replaces this process by delcert-check with these arguments. Returns only by throwing: std::runtime_error if the
/// checker is not found or cannot be run.
[[noreturn]] void run_checker(const std::vector<std::string>& arguments);

}  // namespace delcert
