#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "apps/other_programs.hpp"
#include "apps/printable.hpp"
#include "proofs/publication/citation.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"

namespace delcert {

namespace {

struct CiteOptions {
  std::vector<std::string> files;
  bool is_text = false;
};

ExitStatus print_references(const CiteOptions& options) {
  std::vector<Reference> references{reference_of_paper(), reference_of_software()};
  for (const std::string& file : options.files) {
    const CertificateSummary certificate = read_certificate(file);
    try {
      references.push_back(reference_of(certificate));
    } catch (const InputError& error) {
      throw InputError(file + ": " + error.what());
    }
  }
  for (const Reference& reference : references) {
    if (&reference != &references.front() && !options.is_text) std::cout << "\n";
    std::cout << (options.is_text ? text_of(reference) : bibtex_of(reference));
  }
  return ExitStatus::verified;
}

}  // namespace

void add_cite(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<CiteOptions>();
  CLI::App* command = add_named(program, about_cite);
  command->add_option("CERTIFICATE", options->files, "Certificates, plain or compressed");
  const auto read_format = [options](const std::string& name) {
    const std::vector<std::string_view> names{"bibtex", "text"};
    if (name != "bibtex" && name != "text") {
      throw CLI::ValidationError("--format",
                                 "no format " + shortened(name) + suggestion(name, names) + " (formats: bibtex, text)");
    }
    options->is_text = name == "text";
  };
  command->add_option_function<std::string>("--format", read_format, "The form of the references (default bibtex)")
      ->type_name("bibtex|text");
  command->footer(
      "The keys are those of \\cite in the table that delcert info --latex prints.\n\n"
      "Examples:\n"
      "  delcert cite torus-3.json.zst bolza.json.zst > certificates.bib\n"
      "  delcert cite --format text");
  command->callback([options, &chosen] { chosen = [options] { return print_references(*options); }; });
}

}  // namespace delcert
