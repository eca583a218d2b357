#include "apps/complex_report.hpp"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "apps/printable.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certification/level_line.hpp"
#include "proofs/certification/report_json.hpp"
#include "proofs/certification/report_parts.hpp"

namespace delcert {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::string report_text(const ComplexReport& report) {
  const GivenComplexClaims& claims = report.claims;
  std::string out = fmt::format(
      "{}, a complex of dimension {}, curvature {}\n\n"
      "complex      {} points, edges ≤ ε = {}\n"
      "group        generators: {}; elements besides the identity: {}\n"
      "levels\n",
      printable(report.manifold), report.dimension, sign_of(report.curvature), report.points,
      decimal_upper(claims.longest_edge), report.generators, report.elements);
  for (const std::string& level : claims.levels.names())
    out += fmt::format("  {:<3} {}\n", level, level_line(claims.levels, level, claims.longest_edge));
  for (const std::string& reason : claims.not_reached) out += "  not reached: " + reason + "\n";
  out += "checked      delcert-check verified every level\nstages\n";
  for (const StageClock::Stage& stage : report.stages)
    out += fmt::format("  {:<34} {:8.3f} s\n", stage.name, stage.seconds);
  return out + fmt::format("certificate  {}\n", report.certificate);
}

std::string report_json(const ComplexReport& report) {
  const GivenComplexClaims& claims = report.claims;
  nlohmann::ordered_json json;
  json["format"] = "delcert-complex-report";
  json["version"] = 1;
  json["manifold"] = {{"name", report.manifold},
                      {"family", family_of(report.curvature)},
                      {"dimension", report.dimension},
                      {"curvature", sign_of(report.curvature)}};
  json["points"] = report.points;
  json["simplices"] = claims.levels.manifold->simplices;
  json["generators"] = report.generators;
  json["elements"] = report.elements;
  json["longest_edge"] = upper_json(claims.longest_edge, Margin::Unit::length, claims.longest_edge);
  json["levels"] = levels_json(claims.levels, claims.longest_edge);
  json["not_reached"] = claims.not_reached;
  json["checker"] = nlohmann::ordered_json::parse(report.checker);
  json["stages"] = stages_json(report.stages);
  json["certificate"] = report.certificate;
  return json.dump(2) + "\n";
}

std::string in_names_of(const ComplexDescription& complex, std::string_view message) {
  const auto name_of = [](const std::vector<std::string>& names, std::size_t number) {
    return number < names.size() ? names[number] : std::to_string(number);
  };
  std::string result;
  bool in_braces = false;
  while (!message.empty()) {
    const char c = message.front();
    if (!is_digit(c) || (!result.empty() && (is_digit(result.back()) || result.back() == '.'))) {
      if (c == '{' || c == '}') in_braces = c == '{';
      result += c;
      message.remove_prefix(1);
      continue;
    }
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(message.data(), message.data() + message.size(), number);
    const auto length = static_cast<std::size_t>(end - message.data());
    const std::string digits(message.substr(0, length));
    message.remove_prefix(length);
    if (in_braces) {
      result += name_of(complex.point_names, number);
    } else if (result.ends_with("label ")) {
      result.replace(result.size() - 6, 6, "point ");
      result += name_of(complex.point_names, number);
    } else if (result.ends_with("generator ") && number > 0 &&
               number <= complex.generators.size() + static_cast<std::size_t>(complex.form.dimension())) {
      result += complex.letter_name(number);
    } else {
      result += digits;
    }
  }
  return result;
}

std::string findings_text(const ComplexDescription& complex, const std::string& output) {
  try {
    const auto json = nlohmann::ordered_json::parse(output);
    std::string text;
    const auto add = [&](const nlohmann::ordered_json& finding) {
      const std::string line = "\n  " + finding.at("rule").get<std::string>() + ": " +
                               in_names_of(complex, finding.at("what").get<std::string>());
      // What several levels rest on is found at each of them.
      if ((text + "\n").find(line + "\n") == std::string::npos) text += line;
    };
    if (!json.at("malformed").is_null()) add(json.at("malformed"));
    for (const auto& level : json.at("levels")) {
      for (const auto& finding : level.at("findings")) add(finding);
    }
    if (text.empty() && json.at("status") != "verified") text = "\n  " + json.at("status").get<std::string>();
    return text;
  } catch (const nlohmann::json::exception&) {
    throw std::runtime_error("the output of delcert-check is not its JSON");
  }
}

}  // namespace delcert
