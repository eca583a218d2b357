#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "apps/claim_options.hpp"
#include "apps/other_programs.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/formula/latex.hpp"
#include "proofs/formula/vocabulary_text.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/paper_labels.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"

namespace delcert {

namespace {

void print_parameters(const Claim& claim) {
  for (const auto& [name, range] : claim.parameters) {
    std::cout << "  for all " << name << " in " << (range.has_lower ? "[" : "(")
              << (range.lower ? exact_text(*range.lower) : "-infinity") << ", "
              << (range.upper ? exact_text(*range.upper) : "infinity") << (range.has_upper ? "]" : ")") << "\n";
  }
}

void print_step(const Step& step) {
  std::cout << "  step " << step.name << (step.lines.empty() ? "" : ", lines " + step.lines) << " ("
            << name_of(step.status) << "): " << step.claim.text << "\n";
  for (const auto& [name, range] : step.parameters) {
    std::cout << "    for all " << name << " in " << step_range_text(range) << "\n";
  }
  for (const Statement& abbreviation : step.abbreviations) {
    std::cout << "    let " << abbreviation.name << " = " << abbreviation.text << "\n";
  }
  for (const Statement& hypothesis : step.hypotheses) std::cout << "    given " << hypothesis.text << "\n";
  for (const auto& [name, value] : step.constants)
    std::cout << "    constant " << name << " = " << exact_text(value) << "\n";
  if (!step.note.empty()) std::cout << "    note: " << step.note << "\n";
}

void print_claim(const Claim& claim) {
  std::cout << claim.name << (claim.title.empty() ? "" : ": " + claim.title) << "\n";
  if (!claim.source.empty()) std::cout << "  source: " << claim.source << " (" << name_of(claim.status) << ")\n";
  if (!claim.instance.empty()) {
    const InstanceClass& its_class = instance_class(claim.instance);
    std::cout << "  about: " << its_class.name() << ", " << its_class.meaning() << "\n";
  }
  print_parameters(claim);
  for (const Statement& abbreviation : claim.abbreviations) {
    std::cout << "  let " << abbreviation.name << " = " << abbreviation.text << "\n";
  }
  for (const Hypothesis& hypothesis : claim.hypotheses) {
    std::cout << "  given " << hypothesis.name << ": " << hypothesis.text << "\n";
    if (!hypothesis.no_twin.empty()) std::cout << "    without it: " << hypothesis.no_twin << "\n";
  }
  for (const Conclusion& conclusion : claim.conclusions) {
    std::cout << "  show " << conclusion.name << ": " << conclusion.text << "\n";
    if (conclusion.base) std::cout << "    base: " << conclusion.base->text << "\n";
    if (conclusion.twin) std::cout << "    twin, to be refuted: " << conclusion.twin->text << "\n";
    if (!conclusion.no_twin.empty()) std::cout << "    no twin: " << conclusion.no_twin << "\n";
  }
  for (const Step& step : claim.steps) print_step(step);
  if (!claim.note.empty()) std::cout << "  note: " << claim.note << "\n";
}

void print_latex_of(const Claim& claim) { std::cout << "{\\raggedright\n" << latex_of(claim) << "\\par}\n"; }

ExitStatus list_claims() {
  for (const Claim& claim : builtin_files()) {
    std::cout << fmt::format("{:45} {:42} {:8} {}\n", claim.name, claim.source, name_of(claim.status),
                             claim.instance.empty() ? "steps only" : claim.instance);
  }
  return ExitStatus::verified;
}

ExitStatus list_classes() {
  for (const InstanceClass* each : instance_classes()) {
    std::cout << each->name() << ": " << each->meaning() << "\n";
    for (const auto& [name, type] : each->signature()) std::cout << "  " << name << ", a " << type.text() << "\n";
  }
  return ExitStatus::verified;
}

/// The lines about what has the word in its name or meaning; all with their heads if there is no word.
ExitStatus list_functions(const std::string& word) {
  const Vocabulary& vocabulary = full_vocabulary();
  const std::string table = vocabulary_table(vocabulary);
  if (word.empty()) {
    std::cout << table;
    return ExitStatus::verified;
  }
  std::string found;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("| `") && line.find(word) != std::string::npos) found += line + "\n";
  }
  if (found.empty()) {
    std::vector<std::string> names;
    for (const auto& [name, function] : vocabulary.functions()) names.push_back(name);
    for (const auto& [name, definition] : vocabulary.definitions()) names.push_back(name);
    throw InputError("nothing that formulas can use has \"" + shortened(word) + "\" in its name or meaning" +
                     suggestion(word, names));
  }
  std::cout << found;
  return ExitStatus::verified;
}

}  // namespace

void add_claims(CLI::App& program, Action& chosen) {
  CLI::App* command = add_named(program, about_claims);
  command->require_subcommand(0, 1);
  CLI::App* show = command->add_subcommand("show", "Print claims, of the library or from TOML files");
  const auto options = std::make_shared<ClaimOptions>();
  add_claim_options(*show, *options);
  const auto latex = std::make_shared<bool>(false);
  show->add_flag("--latex", *latex, "Print LaTeX (amsmath)");
  show->callback([options, latex, &chosen] {
    chosen = [options, latex] {
      for (const Claim& claim : claims_of(*options)) *latex ? print_latex_of(claim) : print_claim(claim);
      return ExitStatus::verified;
    };
  });
  CLI::App* classes = command->add_subcommand("classes", "Print the instance classes and the names that they bind");
  classes->callback([&chosen] { chosen = list_classes; });
  CLI::App* functions =
      command->add_subcommand("functions", "Print what formulas can use, with types and meaning, in Markdown");
  const auto word = std::make_shared<std::string>();
  functions->add_option("WORD", *word, "Only what has this in its name or meaning, a line each");
  functions->callback([word, &chosen] { chosen = [word] { return list_functions(*word); }; });
  CLI::App* labels = command->add_subcommand("labels", "Print which label of the paper is which claim, in Markdown");
  labels->callback([&chosen] {
    chosen = [] {
      std::cout << paper_to_code(builtin_claim_list());
      return ExitStatus::verified;
    };
  });
  command->footer(
      "Without a subcommand: the claims of the library, one a line, with source, status and instance class.\n\n"
      "Examples:\n"
      "  delcert claims\n"
      "  delcert claims show thickness-and-singular-value\n"
      "  delcert claims show my-claim.toml\n"
      "  delcert claims show --latex --all > claims.tex\n"
      "  delcert claims classes\n"
      "  delcert claims functions\n"
      "  delcert claims functions circumradius\n"
      "  delcert claims labels");
  command->callback([command, &chosen] {
    if (command->get_subcommands().empty()) chosen = list_claims;
  });
}

}  // namespace delcert
