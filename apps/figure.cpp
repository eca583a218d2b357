#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "apps/commands.hpp"
#include "apps/other_programs.hpp"
#include "apps/witness_file.hpp"
#include "proofs/certificate/certificate_facts.hpp"
#include "proofs/drawing/figure/figure_pdf.hpp"
#include "proofs/drawing/figure/picture.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct FigureOptions {
  std::string file;
  std::string output;
  bool plain = false;
};

Figure figure_of_certificate(const FigureOptions& options) {
  const CertificateSummary certificate = read_certificate(options.file);
  require_seal(certificate);
  Figure figure = picture_of(drawing_of(certificate, {}), {!options.plain, !options.plain});
  figure.description = origin_text(certificate, Verification::not_asked) + "; " + figure.description;
  return figure;
}

ExitStatus write_figure(const FigureOptions& options) {
  const std::string ending = std::filesystem::path(options.output).extension().string();
  if (ending != ".svg" && ending != ".pdf" && ending != ".tikz" && ending != ".tex") {
    throw InputError("--output " + options.output +
                     ": the name ends in .svg or .pdf, or in .tikz or .tex for a tikzpicture");
  }
  const bool is_witness = witness_file(options.file) != WitnessFile::other;
  if (is_witness && is_left_to_claims(about_attack.name)) hand_over_to(claims_program);
  try {
    Figure figure = is_witness ? witness_figure(options.file) : figure_of_certificate(options);
    if (options.plain) figure.scale.reset();
    const auto text_of = ending == ".svg" ? svg_of : ending == ".pdf" ? pdf_of : tikz_of;
    write_file_atomically(options.output, text_of(figure));
    std::cout << options.output << ": " << figure.description << "\n";
  } catch (const InputError& error) {
    const std::string message = error.what();
    const bool is_located = message.starts_with(options.output) || message.starts_with(options.file);
    throw InputError(is_located ? message : options.file + ": " + message);
  }
  return ExitStatus::verified;
}

}  // namespace

void add_figure(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<FigureOptions>();
  CLI::App* command = add_named(program, about_figure);
  command->add_option("FILE", options->file, "A certificate, plain or compressed, or a witness of attack or tighten")
      ->required();
  command
      ->add_option("--output", options->output,
                   "The file to write: x.svg or x.pdf, or x.tikz or x.tex for a tikzpicture")
      ->type_name("FILE")
      ->required();
  command->add_flag("--plain", options->plain, "Neither mark the worst star nor draw a scale");
  command->footer(
      "One copy of every triangle, the darker the thicker; the star of a point of the least protection is marked. Of a "
      "witness, its simplices with circumscribed balls and least altitudes.\n\n"
      "Examples:\n"
      "  delcert figure torus-2.json.zst --output torus-2.svg\n"
      "  delcert figure bolza.json.zst --output bolza.pdf\n"
      "  delcert figure witness.json --output witness.svg");
  command->callback([options, &chosen] { chosen = [options] { return write_figure(*options); }; });
}

}  // namespace delcert
