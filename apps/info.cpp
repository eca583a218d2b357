#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "apps/certificate_picture.hpp"
#include "apps/commands.hpp"
#include "apps/printable.hpp"
#include "kernel/number/decimal_bounds.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/stated_levels.hpp"
#include "proofs/certificate/summary_json.hpp"
#include "proofs/certification/report_json.hpp"
#include "proofs/publication/certificate_table.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"
#include "support/text_table.hpp"

namespace delcert {

namespace {

struct InfoOptions {
  std::string file;
  std::string picture;
  bool json = false;
  bool latex = false;
};

constexpr std::array<std::string_view, 2> origins{"command", "commit"};

bool is_origin(const std::string& name) { return std::find(origins.begin(), origins.end(), name) != origins.end(); }

std::string json_of(const CertificateSummary& certificate) {
  nlohmann::ordered_json json = summary_json(certificate);
  json["simplices"] = certificate.simplices.size();
  json["levels"] = levels_json(stated_levels(certificate), certificate.parameter("sampling_radius"));
  for (const auto& [name, value] : certificate.software) {
    if (is_origin(name)) json[name] = value;
  }
  return ascii_text(json, 2) + "\n";
}

/// What a parameter is nearly, if it is a number that is not read at a glance.
std::string near_text(const std::string& value) {
  try {
    const Rational x = parse_exact(value);
    if (x.denominator() == 1) return "";
    const std::string decimal = decimal_lower(x, 4);
    return (decimal == decimal_upper(x, 4) ? "= " : "≈ ") + decimal;
  } catch (const ExactTextError&) {
    return "";
  }
}

std::string parameters_text(const CertificateSummary& certificate) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [key, value] : certificate.parameters)
    rows.push_back({"  " + printable(key), printable(value), near_text(value)});
  return text_table(rows);
}

std::string levels_text(const CertificateSummary& certificate) {
  const Rational radius = certificate.parameter("sampling_radius");
  std::vector<std::vector<std::string>> rows;
  const auto stated = stated_levels(certificate);
  for (std::size_t at = 0; at < stated.size(); ++at) {
    std::string name = fmt::format("  {:<3}", printable(stated[at].name));
    if (stated[at].entries.empty()) rows.push_back({name});
    for (std::size_t entry = 0; entry < stated[at].entries.size(); ++entry) {
      const std::string key = printable(stated[at].entries[entry].key);
      const std::vector<Margin>& margins = stated[at].entries[entry].margins;
      if (margins.empty()) rows.push_back({name, key, printable(certificate.levels[at].second[entry].second)});
      for (const Margin& margin : margins) {
        const std::string relation = margin.side == Margin::Side::lower ? "≥ " : "≤ ";
        const std::string in_radii = safe_decimal_in_radii(margin, radius);
        const char* unit = margin.unit == Margin::Unit::squared_length ? " ε²" : " ε";
        rows.push_back({name, key, relation + exact_text(margin.value),
                        relation + safe_decimal(margin.value, margin.side),
                        in_radii.empty() ? "" : relation + in_radii + unit});
        name.clear();
      }
      name.clear();
    }
  }
  return text_table(rows);
}

std::string text_of(const CertificateSummary& certificate) {
  std::string out =
      fmt::format("{} ({}, dimension {}), {} points\n", printable(certificate.manifold.name),
                  printable(certificate.family), certificate.manifold.dimension.value, certificate.points.size());
  out += "parameters\n" + parameters_text(certificate);
  out += "levels claimed (delcert check verifies them); lengths, also in units of ε, the sampling radius\n";
  out += levels_text(certificate) + "made with\n ";
  for (const auto& [name, value] : certificate.software) {
    if (!is_origin(name)) out += fmt::format(" {} {}", printable(name), printable(value));
  }
  out += "\n";
  for (const auto& [name, value] : certificate.software) {
    if (is_origin(name)) out += fmt::format("{:<8}{}\n", printable(name), printable(value));
  }
  return out + fmt::format("sha256 {}\n", printable(certificate.seal));
}

/// The whole output, or an InputError that names the file.
std::string output_of(const CertificateSummary& certificate, const InfoOptions& options) {
  try {
    if (options.json) return json_of(certificate);
    return options.latex ? certificate_latex(certificate) : text_of(certificate);
  } catch (const InputError& error) {
    throw InputError(options.file + ": " + error.what());
  }
}

ExitStatus print_info(const InfoOptions& options) {
  const CertificateSummary certificate = read_certificate(options.file);
  const std::string output = output_of(certificate, options);
  if (!options.picture.empty()) write_file_atomically(options.picture, certificate_picture(certificate));
  std::cout << output;
  return ExitStatus::verified;
}

}  // namespace

void add_info(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand("info", "Say what a certificate claims, without verifying it");
  command->add_option("FILE", options->file, "A certificate, plain or compressed")->required();
  command->add_option("--picture", options->picture, "Draw the complex as SVG (dimension 2)")->type_name("FILE");
  CLI::Option* json = command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--latex", options->latex, "Print a LaTeX table (booktabs)")->excludes(json);
  command->footer(
      "Examples:\n"
      "  delcert info torus-3.json.zst\n"
      "  delcert info torus-2.json.zst --picture torus-2.svg\n"
      "  delcert info torus-2.json.zst --latex > torus-2.tex");
  command->callback([options, &chosen] { chosen = [options] { return print_info(*options); }; });
}

}  // namespace delcert
