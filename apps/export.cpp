#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "apps/checker_process.hpp"
#include "apps/kept_memory.hpp"
#include "apps/other_programs.hpp"
#include "proofs/certificate/reader.hpp"
#include "proofs/drawing/formats/certificate_export.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"

namespace delcert {

namespace {

struct ExportOptions {
  std::string file;
  ExportRequest request;
  bool only_verified = false;
  std::string output;
};

/// What delcert-check says. Throws Rejection and Undecided as it does.
Verification verified(const std::string& file) {
  const int status = run_checker_on(installed_checker(), file).status;
  if (status == 0) return Verification::verified;
  if (status == 1) throw Rejection(file + ": delcert-check rejects it (delcert check says why); nothing is written");
  if (status == 2) throw Undecided(file + ": delcert-check cannot decide it; nothing is written");
  if (status == 3) throw InputError(file + ": delcert-check cannot read it (delcert check says why)");
  throw std::runtime_error("delcert-check ended with status " + std::to_string(status));
}

ExportedText export_of(const ExportOptions& options) {
  const CertificateSummary certificate = read_certificate(options.file);
  try {
    require_seal(certificate);
    options.request.format->check(certificate);
    ExportRequest request = options.request;
    if (options.only_verified) request.verification = verified(options.file);
    return exported(certificate, request);
  } catch (const InputError& error) {
    const std::string message = error.what();
    throw InputError(message.starts_with(options.file) ? message : options.file + ": " + message);
  }
}

ExitStatus write_export(const ExportOptions& options) {
  keep_freed_memory();
  if (!options.output.empty() && std::filesystem::exists(std::filesystem::symlink_status(options.output)))
    throw InputError(options.output + ": the file exists and is not replaced");
  const ExportedText result = export_of(options);
  if (options.output.empty()) {
    std::cout << result.text;
  } else {
    write_file_atomically(options.output, result.text);
    std::cout << fmt::format("{}: {}, {}\n", options.output, result.summary,
                             options.only_verified ? "verified" : "not verified");
  }
  return ExitStatus::verified;
}

/// An option whose values are the names of these.
template <class Value>
CLI::Option* add_name_option(CLI::App& command, const std::string& option, std::vector<Value> values,
                             const std::string& help, const std::function<void(Value)>& set) {
  std::vector<std::string_view> names;
  for (const Value value : values) names.push_back(name_of(value));
  const auto read = [option, values, names, set](const std::string& text) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (names[k] == text) return set(values[k]);
    }
    throw CLI::ValidationError(option, "no such thing as " + shortened(text) + suggestion(text, names) + " (" +
                                           fmt::format("{}", fmt::join(names, ", ")) + ")");
  };
  return command.add_option_function<std::string>(option, read, help)
      ->type_name(fmt::format("{}", fmt::join(names, "|")));
}

}  // namespace

void add_export(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = add_named(program, about_export);
  command->add_option("FILE", options->file, "A certificate, plain or compressed")->required();
  const auto read_format = [options](const std::string& name) {
    try {
      options->request.format = &export_format(name);
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError("--format", error.what());
    }
  };
  command->add_option_function<std::string>("--format", read_format, "The format of the file: see below")
      ->required()
      ->type_name("NAME");
  const CLI::Option* copies = add_name_option<DrawingCopies>(
      *command, "--copies", {DrawingCopies::quotient, DrawingCopies::cell, DrawingCopies::glued},
      "Each label once; each simplex once, in one fundamental cell (the default); the cell "
      "and all copies that touch it",
      [options](DrawingCopies chosen_copies) { options->request.drawing.copies = chosen_copies; });
  const CLI::Option* model = add_name_option<DrawingModel>(
      *command, "--model",
      {DrawingModel::unit, DrawingModel::conformal, DrawingModel::stereographic, DrawingModel::gnomonic,
       DrawingModel::space},
      "The model for coordinates; each family has a default",
      [options](DrawingModel chosen_model) { options->request.drawing.model = chosen_model; });
  command->add_flag("--only-verified", options->only_verified,
                    "Run delcert-check first, and write nothing unless it verifies");
  command->add_flag("--exact", options->request.is_exact, "json: with the exact coordinates of the certificate");
  command->add_flag("--simplify", options->request.simplify,
                    "Formats without coordinates: fewer simplices, by contractions of edges under the link condition");
  command->add_option("--output", options->output, "The file to write; standard output without it")->type_name("FILE");
  std::string footer = "Formats:\n";
  for (const ExportFormat& format : export_formats())
    footer += fmt::format("  {:<14}{}\n", format.name, format.description);
  command->footer(footer +
                  "\nExamples:\n"
                  "  delcert export torus-3.json.zst --format json --output torus-3-drawing.json\n"
                  "  delcert export bolza.json.zst --format off --copies glued --model gnomonic --output bolza.off\n"
                  "  delcert export poincare.json.zst --format isosig --simplify");
  command->callback([options, copies, model, &chosen] {
    const bool is_drawn = options->request.format->has_coordinates;
    const std::string of_format = " of the format " + std::string(options->request.format->name);
    for (const CLI::Option* option : {copies, model}) {
      if (!is_drawn && option->count() > 0)
        throw CLI::ValidationError(option->get_name(), "there are no coordinates in files" + of_format);
    }
    if (is_drawn && options->request.simplify)
      throw CLI::ValidationError("--simplify", "the result would have no measures; not in files" + of_format);
    if (options->request.is_exact && options->request.format->name != "json")
      throw CLI::ValidationError("--exact", "there are no exact numbers in files" + of_format);
    chosen = [options] { return write_export(*options); };
  });
}

}  // namespace delcert
