#include "proofs/report/certificate_item.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/summary_json.hpp"
#include "proofs/drawing/drawing.hpp"
#include "proofs/report/decimation.hpp"
#include "proofs/report/packed_drawing.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// From the most to the least that a page says of each simplex, with the note that goes with it.
struct DetailChoice {
  PackingDetail detail;
  const char* note;
};

constexpr std::array<DetailChoice, 4> choices{{
    {{2, true, true}, ""},
    {{2, false, true}, "To keep this page small, exact coordinates are left out; the certificate has them."},
    {{1, false, true},
     "To keep this page small, exact coordinates are left out, and measures of single simplices are rounded to one of "
     "254 values; the certificate has what they come from."},
    {{1, false, false},
     "To keep this page small, exact coordinates, circumradii and hinges of single simplices are left out, and other "
     "measures are rounded to one of 254 values; the certificate has what they come from."},
}};

bool has_points_in_the_frame(const CertificateSummary& certificate) {
  return certificate.family == "flat-torus" || certificate.family == "euclidean-ball";
}

/// What the numbers of `exact_coordinates` are.
std::vector<std::string> exact_names(const CertificateSummary& certificate) {
  std::vector<std::string> result;
  const auto add = [&](const std::string& name, std::size_t size) {
    for (std::size_t axis = 1; axis <= size; ++axis) result.push_back(name + " " + std::to_string(axis));
  };
  const bool in_frame = has_points_in_the_frame(certificate);
  if (!in_frame && !certificate.net.empty()) add("net point", certificate.net.front().size());
  if (!certificate.points.empty()) add(in_frame ? "coordinate" : "moved in its chart by", certificate.points[0].size());
  return result;
}

/// Of each label. Where the points are displacements in charts, after the points of the net.
std::vector<std::string> exact_coordinates(const CertificateSummary& certificate) {
  std::vector<std::string> result;
  result.reserve(certificate.points.size());
  const bool with_net = !has_points_in_the_frame(certificate) && certificate.net.size() == certificate.points.size();
  for (std::size_t label = 0; label < certificate.points.size(); ++label) {
    std::string line;
    const auto add = [&line](const std::vector<Rational>& numbers) {
      for (const Rational& number : numbers) line += (line.empty() ? "" : " ") + exact_text(number);
    };
    if (with_net) add(certificate.net[label]);
    add(certificate.points[label]);
    result.push_back(std::move(line));
  }
  return result;
}

void add_drawing(const CertificateSummary& certificate, PageItem& item) {
  const Drawing whole = drawing_of(certificate, {});
  const Drawing drawing = decimated(whole, most_simplices_of_a_page);
  const std::vector<std::string> exact = exact_coordinates(certificate);
  for (const auto& [detail, note] : choices) {
    PackedDrawing packed = packed_drawing(drawing, exact, detail);
    const std::size_t size = packed.block.size() + packed.description.dump().size();
    if (size > page_budget(drawing.simplex_count()) && &note != &choices.back().note) continue;
    item.data["drawing"] = std::move(packed.description);
    item.data["drawing"]["exact_names"] = exact_names(certificate);
    item.block = std::move(packed.block);
    if (*note != '\0') item.data["notes"].push_back(note);
    if (drawing.simplex_count() < whole.simplex_count()) {
      item.data["notes"].push_back(
          fmt::format("To keep this page small, it has {} of the {} simplices: those that share a point with one of "
                      "the ten worst of each "
                      "measure, so that their stars are whole, and an even part of the others, whose stars are not. "
                      "Levels and margins are "
                      "those of all.",
                      drawing.simplex_count(), whole.simplex_count()));
    }
    if (!drawing.projection.empty()) item.data["notes"].push_back("Drawn by the " + drawing.projection + ".");
    return;
  }
}

}  // namespace

std::size_t page_budget(std::size_t simplices) { return std::min<std::size_t>(600000 + 9 * simplices, 4800000); }

PageItem certificate_item(const CertificateSummary& certificate, const ShownFile& file,
                          const std::optional<CheckRecord>& check) {
  PageItem item;
  item.data = {{"kind", "certificate"}, {"file", file.name}};
  item.data["header"] = summary_json(certificate);
  item.data["header"]["file_sha256"] = file.sha256;
  item.data["seal_fits"] = certificate.seal == certificate.sealed_bytes;
  item.data["simplices"] = certificate.simplices.size();
  item.data["check"] = nullptr;
  if (check) item.data["check"] = {{"checker", check->checker}, {"date", check->date}, {"result", check->result}};
  item.data["notes"] = nlohmann::ordered_json::array();
  item.data["drawing"] = nullptr;
  try {
    add_drawing(certificate, item);
  } catch (const InputError& reason) {
    item.data["notes"].push_back(std::string("There is no picture, and nothing is measured: ") + reason.what());
  }
  return item;
}

}  // namespace delcert
