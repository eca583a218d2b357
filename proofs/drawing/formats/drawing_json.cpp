#include "proofs/drawing/formats/drawing_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/summary_json.hpp"
#include "proofs/drawing/formats/number_text.hpp"

namespace delcert {

namespace {

using DrawingJson = nlohmann::ordered_json;

/// Written by hand, as they may be millions.
class DrawingText {
 public:
  void key(const char* name) {
    text += text.empty() || text.back() == '{' ? "" : ",";
    fmt::format_to(std::back_inserter(text), "\"{}\":", name);
  }
  void json(const char* name, const DrawingJson& value) {
    key(name);
    text += ascii_text(value);
  }
  void places(const char* name, const std::vector<double>& numbers) {
    key(name);
    list(numbers, [this](double x) { fmt::format_to(std::back_inserter(text), "{:.12g}", x); });
  }
  void integers(const char* name, const std::vector<std::uint32_t>& numbers) {
    key(name);
    list(numbers, [this](std::uint32_t x) { append_number(text, x); });
  }
  /// By the positions of simplices; null where there is none.
  void measure(const char* name, const std::vector<double>& values, const std::vector<std::uint32_t>& positions) {
    key(name);
    if (values.empty()) {
      text += "null";
      return;
    }
    list(positions, [&](std::uint32_t position) {
      const double x = values[position];
      if (std::isfinite(x)) {
        append_measure(text, x);
      } else {
        text += "null";
      }
    });
  }
  template <class List, class Append>
  void list(const List& values, const Append& append) {
    text += '[';
    bool is_first = true;
    for (const auto& value : values) {
      if (!is_first) text += ',';
      is_first = false;
      append(value);
    }
    text += ']';
  }

  std::string text;
};

DrawingJson bound_json(const std::optional<double>& bound) { return bound ? DrawingJson(*bound) : DrawingJson(); }

DrawingJson certificate_json(const CertificateSummary& certificate, Verification verification) {
  const DrawingJson summary = summary_json(certificate);
  DrawingJson result;
  result["sha256"] = certificate.sealed_bytes;
  result["name"] = summary.at("manifold");
  for (const char* key : {"family", "dimension", "points"}) result[key] = summary.at(key);
  result["seed"] = summary.at("parameters").value("seed", "");
  result["verified"] =
      verification == Verification::not_asked ? DrawingJson() : DrawingJson(verification == Verification::verified);
  for (const char* key : {"parameters", "levels_claimed", "software"}) result[key] = summary.at(key);
  return result;
}

DrawingJson exact_rows_json(const std::vector<std::vector<Rational>>& rows) {
  DrawingJson result = DrawingJson::array();
  for (const auto& row : rows) {
    DrawingJson texts = DrawingJson::array();
    for (const Rational& x : row) texts.push_back(exact_text(x));
    result.push_back(std::move(texts));
  }
  return result;
}

}  // namespace

std::string drawing_json(const CertificateSummary& certificate, const Drawing& drawing, Verification verification,
                         bool is_exact) {
  DrawingText out;
  out.text = "{";
  out.json("format", "delcert-drawing");
  out.json("version", 1);
  out.json("certificate", certificate_json(certificate, verification));
  out.json("copies", name_of(drawing.copies));
  out.json("model", name_of(drawing.model));
  out.json("geometry", drawing.geometry);
  out.json("approximate", true);
  out.json("ambient_dimension", drawing.ambient_dimension);
  out.json("projection", drawing.projection);
  out.key("vertices");
  out.text += "{";
  out.places("coordinates", drawing.coordinates);
  out.integers("label", drawing.labels);
  out.integers("lift", drawing.lifts);
  out.text += "}";
  out.json("lifts", drawing.lift_texts);
  out.integers("simplices", drawing.simplices);
  out.json("oriented", drawing.is_oriented);
  out.integers("positions", drawing.positions);
  out.key("measures");
  out.text += "{";
  out.measure("protection", drawing.measures.protection, drawing.positions);
  out.measure("thickness", drawing.measures.thickness, drawing.positions);
  out.measure("circumradius", drawing.measures.circumradius, drawing.positions);
  out.measure("hinge", drawing.measures.hinge, drawing.positions);
  out.text += "}";
  DrawingJson bounds;
  bounds["protection"] = bound_json(drawing.bounds.protection);
  bounds["thickness"] = bound_json(drawing.bounds.thickness);
  bounds["circumradius"] = bound_json(drawing.bounds.circumradius);
  bounds["hinge"] = bound_json(drawing.bounds.hinge);
  out.json("bounds", bounds);
  out.key("matching_faces");
  out.list(drawing.matching_faces, [&out](const MatchingFaces& pair) {
    const auto number = [&out](std::uint32_t vertex) { append_number(out.text, vertex); };
    out.text += '[';
    out.list(pair.first, number);
    out.text += ',';
    out.list(pair.second, number);
    out.text += ',' + ascii_text(pair.step) + ']';
  });
  out.key("domain");
  if (drawing.domain.empty()) {
    out.text += "null";
  } else {
    out.text += "{";
    out.places("edges", drawing.domain);
    out.text += "}";
  }
  if (is_exact) {
    DrawingJson exact;
    exact["coordinates"] = exact_rows_json(certificate.points);
    exact["net"] = exact_rows_json(certificate.net());
    out.json("exact", exact);
  }
  return std::move(out.text) + "}\n";
}

}  // namespace delcert
