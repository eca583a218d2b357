// A part of delcert-certify alone: of the subcommands that publish certificates it has the names only.

#include "apps/certificate_picture.hpp"
#include "apps/other_programs.hpp"

namespace delcert {

bool is_left_to_publishing(std::string_view subcommand) { return is_among(publishing_commands, subcommand); }

// Never parsed: main hands over before.
void add_cite(CLI::App& program, Action&) { add_named(program, about_cite); }
void add_figure(CLI::App& program, Action&) { add_named(program, about_figure); }
void add_bundle(CLI::App& program, Action&) { add_named(program, about_bundle); }
void add_export(CLI::App& program, Action&) { add_named(program, about_export); }
void add_report(CLI::App& program, Action&) { add_named(program, about_report); }

std::string certificate_picture(const CertificateSummary&) { hand_over_to(publishing_program); }

}  // namespace delcert
