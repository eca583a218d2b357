#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>

#include "apps/commands.hpp"
#include "proofs/drawing/certificate_facts.hpp"
#include "proofs/drawing/picture.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct FigureOptions {
  std::string file;
  std::string output;
  bool plain = false;
};

ExitStatus write_figure(const FigureOptions& options) {
  const std::string ending = std::filesystem::path(options.output).extension().string();
  if (ending != ".svg" && ending != ".tikz" && ending != ".tex") {
    throw InputError(
        "--output " + options.output +
        ": the name ends in .svg, or in .tikz or .tex for a tikzpicture (of SVG, rsvg-convert -f pdf makes "
        "PDF)");
  }
  const CertificateSummary certificate = read_certificate(options.file);
  try {
    require_seal(certificate);
    Figure figure = picture_of(drawing_of(certificate, {}), {!options.plain, !options.plain});
    figure.description = origin_text(certificate, Verification::not_asked) + "; " + figure.description;
    write_file_atomically(options.output, ending == ".svg" ? svg_of(figure) : tikz_of(figure));
    std::cout << options.output << ": " << figure.description << "\n";
  } catch (const InputError& error) {
    const std::string message = error.what();
    throw InputError(message.starts_with(options.output) ? message : options.file + ": " + message);
  }
  return ExitStatus::verified;
}

}  // namespace

void add_figure(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<FigureOptions>();
  CLI::App* command = program.add_subcommand("figure", "Draw the complex of a two-dimensional certificate for a paper");
  command->add_option("FILE", options->file, "A certificate, plain or compressed")->required();
  command->add_option("--output", options->output, "The file to write: x.svg, or x.tikz or x.tex for a tikzpicture")
      ->type_name("FILE")
      ->required();
  command->add_flag("--plain", options->plain, "Neither mark the worst star nor draw a scale");
  command->footer(
      "One copy of every triangle, the darker the thicker; the star of a point of the least protection is marked.\n\n"
      "Examples:\n"
      "  delcert figure torus-2.json.zst --output torus-2.svg\n"
      "  delcert figure bolza.json.zst --output bolza.tikz");
  command->callback([options, &chosen] { chosen = [options] { return write_figure(*options); }; });
}

}  // namespace delcert
