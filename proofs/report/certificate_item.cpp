#include "proofs/report/certificate_item.hpp"

#include <utility>

#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/summary_json.hpp"
#include "proofs/drawing/drawing.hpp"
#include "proofs/report/fitting_drawing.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

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
  const auto net = in_frame ? std::vector<std::vector<Rational>>() : certificate.net();
  if (!net.empty()) add("net point", net.front().size());
  if (!certificate.points.empty()) add(in_frame ? "coordinate" : "moved in its chart by", certificate.points[0].size());
  return result;
}

/// Of each label. Where the points are displacements in charts, after the points of the net.
std::vector<std::string> exact_coordinates(const CertificateSummary& certificate) {
  std::vector<std::string> result;
  result.reserve(certificate.points.size());
  const auto net = has_points_in_the_frame(certificate) ? std::vector<std::vector<Rational>>() : certificate.net();
  const bool with_net = net.size() == certificate.points.size();
  for (std::size_t label = 0; label < certificate.points.size(); ++label) {
    std::string line;
    const auto add = [&line](const std::vector<Rational>& numbers) {
      for (const Rational& number : numbers) line += (line.empty() ? "" : " ") + exact_text(number);
    };
    if (with_net) add(net[label]);
    add(certificate.points[label]);
    result.push_back(std::move(line));
  }
  return result;
}

void add_drawing(const CertificateSummary& certificate, PageItem& item) {
  const Drawing whole = drawing_of(certificate, {});
  FittingDrawing fitting = fitting_drawing(whole, exact_coordinates(certificate));
  item.data["drawing"] = std::move(fitting.packed.description);
  item.data["drawing"]["exact_names"] = exact_names(certificate);
  item.block = std::move(fitting.packed.block);
  for (std::string& note : fitting.notes) item.data["notes"].push_back(std::move(note));
  if (!whole.projection.empty()) item.data["notes"].push_back("Drawn by the " + whole.projection + ".");
}

}  // namespace

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
