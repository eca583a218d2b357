#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/commands.hpp"
#include "apps/printable.hpp"
#include "proofs/certificate/picture.hpp"
#include "proofs/certificate/reader.hpp"
#include "support/atomic_file.hpp"

namespace delcert {

namespace {

struct InfoOptions {
  std::string file;
  std::string picture;
  bool json = false;
};

using Entries = std::vector<std::pair<std::string, std::string>>;

nlohmann::ordered_json object_of(const Entries& entries) {
  nlohmann::ordered_json result = nlohmann::ordered_json::object();
  for (const auto& [key, value] : entries) result[key] = value;
  return result;
}

std::string json_of(const CertificateSummary& certificate) {
  nlohmann::ordered_json json;
  json["manifold"] = certificate.manifold.name;
  json["family"] = certificate.family;
  json["dimension"] = certificate.manifold.dimension.value;
  json["points"] = certificate.points.size();
  json["parameters"] = object_of(certificate.parameters);
  json["levels_claimed"] = nlohmann::ordered_json::object();
  for (const auto& [level, margins] : certificate.levels) json["levels_claimed"][level] = object_of(margins);
  json["software"] = object_of(certificate.software);
  json["sha256"] = certificate.seal;
  // Escape sequences for all but ASCII: what a name holds may not reach a terminal.
  return json.dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string text_of(const CertificateSummary& certificate) {
  std::string out =
      fmt::format("{} ({}, dimension {}), {} points\n", printable(certificate.manifold.name),
                  printable(certificate.family), certificate.manifold.dimension.value, certificate.points.size());
  out += "parameters\n";
  for (const auto& [key, value] : certificate.parameters)
    out += fmt::format("  {:<24} {}\n", printable(key), printable(value));
  out += "levels claimed (delcert check verifies them)\n";
  for (const auto& [level, margins] : certificate.levels) {
    out += fmt::format("  {:<3}", printable(level));
    for (const auto& [key, value] : margins) out += fmt::format(" {} {}", printable(key), printable(value));
    out += "\n";
  }
  out += "made with\n ";
  for (const auto& [name, version] : certificate.software)
    out += fmt::format(" {} {}", printable(name), printable(version));
  return out + fmt::format("\nsha256 {}\n", printable(certificate.seal));
}

ExitStatus print_info(const InfoOptions& options) {
  const CertificateSummary certificate = read_certificate(options.file);
  if (!options.picture.empty()) write_file_atomically(options.picture, picture_svg(certificate));
  std::cout << (options.json ? json_of(certificate) : text_of(certificate));
  return ExitStatus::verified;
}

}  // namespace

void add_info(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand("info", "Say what a certificate claims, without verifying it");
  command->add_option("FILE", options->file, "A certificate, plain or compressed")->required();
  command->add_option("--picture", options->picture, "Draw the complex as SVG (dimension 2)")->type_name("FILE");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Examples:\n"
      "  delcert info torus-3.json.zst\n"
      "  delcert info torus-2.json.zst --picture torus-2.svg");
  command->callback([options, &chosen] { chosen = [options] { return print_info(*options); }; });
}

}  // namespace delcert
