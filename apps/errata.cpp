#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "apps/other_programs.hpp"
#include "proofs/errata/errata_text.hpp"

namespace delcert {

namespace {

struct ErrataOptions {
  std::vector<std::string> files;
  bool json = false;
};

std::vector<Erratum> errata_of(const ErrataOptions& options) {
  if (options.files.empty()) return builtin_errata_list();
  std::vector<Erratum> errata;
  for (const std::string& file : options.files) errata.push_back(read_erratum(file));
  sort_by_line(errata);
  return errata;
}

}  // namespace

void add_errata(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<ErrataOptions>();
  CLI::App* command = add_named(program, about_errata);
  command->add_option("files", options->files, "TOML files, one finding each (default: those of the library)");
  command->add_flag("--json", options->json, "Print JSON (default: Markdown)");
  command->footer(
      "Examples:\n"
      "  delcert errata > docs/errata.md\n"
      "  delcert errata --json\n"
      "  delcert errata my-finding.toml");
  command->callback([options, &chosen] {
    chosen = [options] {
      const std::vector<Erratum> errata = errata_of(*options);
      std::cout << (options->json ? errata_json(errata) : errata_markdown(errata));
      return ExitStatus::verified;
    };
  });
}

}  // namespace delcert
