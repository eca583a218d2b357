#pragma once

#include <algorithm>
#include <span>
#include <string_view>

namespace delcert {

/// delcert is three programs in one folder. delcert-certify certifies and reads certificates; delcert-publish can do
/// that and also exports, draws and writes pages; delcert-claims can do everything. Each knows the names of the
/// subcommands that it lacks and hands over to a program that has them. So what is not called for need not be built.
/// delcert itself only knows the names, and becomes one of the three.
struct OtherProgram {
  const char* name;
  const char* part;  ///< what it has, in the plural
};

inline constexpr OtherProgram certifying_program{"delcert-certify", "certificates"};
inline constexpr OtherProgram publishing_program{"delcert-publish", "exports, figures and pages"};
inline constexpr OtherProgram claims_program{"delcert-claims", "claims"};

/// A subcommand by its name and the line that --help has of it.
struct CommandName {
  const char* name;
  const char* description;
};

/// What certificates provide for other programs, papers and browsers.
inline constexpr CommandName about_cite{
    "cite", "Print references to the paper, to delcert and to certificates, for a bibliography"};
inline constexpr CommandName about_figure{"figure",
                                          "Draw a certificate of dimension 1 or 2, or a witness, for a paper"};
inline constexpr CommandName about_bundle{"bundle",
                                          "Put certificates into a ZIP archive, for the supplement of a paper"};
inline constexpr CommandName about_export{
    "export", "Write the complex of a certificate, in approximate coordinates, for another program"};
inline constexpr CommandName about_report{"report", "Write a page for a browser: certificates and witnesses"};

inline constexpr CommandName publishing_commands[] = {about_cite, about_figure, about_bundle, about_export,
                                                      about_report};

/// Claims and proofs.
inline constexpr CommandName about_claims{"claims", "The claims of the library, and what claims can speak of"};
inline constexpr CommandName about_attack{"attack", "Attack claims on random instances, with exact decisions"};
inline constexpr CommandName about_campaign{"campaign",
                                            "Merge the parts of long attacks, show how far they are, recheck them"};
inline constexpr CommandName about_tighten{"tighten", "Search for the instances that come nearest to refuting a claim"};
inline constexpr CommandName about_power{
    "power", "Find by how much each constant and term of a claim can be moved before it is refuted"};
inline constexpr CommandName about_prove{"prove", "Prove the numeric steps of claims for all parameters"};
inline constexpr CommandName about_errata{
    "errata", "Print remarks on the preprint of the paper, with commands that reproduce them"};
inline constexpr CommandName about_tables{
    "tables", "Print the constants of the lemmas: the paper's, provable by the same proof, shown necessary"};
inline constexpr CommandName about_formalise{"formalise", "Write the steps of proofs as files for Coq"};
inline constexpr CommandName claim_commands[] = {about_claims,  about_attack, about_campaign,
                                                 about_tighten, about_power,  about_prove,
                                                 about_errata,  about_tables, about_formalise};

[[nodiscard]] inline bool is_among(std::span<const CommandName> commands, std::string_view subcommand) {
  return std::any_of(commands.begin(), commands.end(),
                     [subcommand](const CommandName& command) { return subcommand == command.name; });
}

}  // namespace delcert
