#include "proofs/drawing/formats/surface_formats.hpp"

#include <fmt/format.h>

#include "proofs/drawing/formats/cell_data.hpp"
#include "proofs/drawing/formats/number_text.hpp"

namespace delcert {

namespace {

void append_point(std::string& out, std::string_view before, const Drawing& drawing, std::size_t vertex) {
  const auto [x, y, z] = space_point(drawing, vertex);
  out += before;
  append_number(out, x);
  out += ' ';
  append_number(out, y);
  out += ' ';
  append_number(out, z);
}

void append_triangle(std::string& out, std::string_view before, const Drawing& drawing, std::size_t simplex,
                     std::uint32_t first) {
  const std::uint32_t* corners = &drawing.simplices[3 * simplex];
  out += before;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k > 0) out += ' ';
    append_number(out, corners[k] + first);
  }
}

}  // namespace

std::string off_text(const ExportContent& content) {
  const Drawing& drawing = *content.drawing;
  std::string out = "OFF\n" + comment_lines("# ", content.origin(), {}) +
                    fmt::format("{} {} 0\n", drawing.vertex_count(), drawing.simplex_count());
  for (std::size_t vertex = 0; vertex < drawing.vertex_count(); ++vertex) {
    append_point(out, "", drawing, vertex);
    out += '\n';
  }
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    append_triangle(out, "3 ", drawing, simplex, 0);
    out += '\n';
  }
  return out;
}

std::string obj_text(const ExportContent& content) {
  const Drawing& drawing = *content.drawing;
  std::string out = comment_lines("# ", content.origin(), {});
  for (std::size_t vertex = 0; vertex < drawing.vertex_count(); ++vertex) {
    append_point(out, "v ", drawing, vertex);
    out += '\n';
  }
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    append_triangle(out, "f ", drawing, simplex, 1);
    out += '\n';
  }
  return out;
}

std::string ply_text(const ExportContent& content) {
  const Drawing& drawing = *content.drawing;
  const std::vector<NamedMeasure> measures = named_measures(drawing);
  std::string out = "ply\nformat ascii 1.0\n" + comment_lines("comment ", content.origin(), lift_lines(drawing)) +
                    fmt::format(
                        "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
                        "property int label\nproperty int lift\nelement face {}\n"
                        "property list uchar int vertex_indices\n",
                        drawing.vertex_count(), drawing.simplex_count());
  for (const NamedMeasure& measure : measures) out += fmt::format("property double {}\n", measure.name);
  out += "end_header\n";
  for (std::size_t vertex = 0; vertex < drawing.vertex_count(); ++vertex) {
    append_point(out, "", drawing, vertex);
    out += ' ';
    append_number(out, drawing.labels[vertex]);
    out += ' ';
    append_number(out, drawing.lifts[vertex]);
    out += '\n';
  }
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    append_triangle(out, "3 ", drawing, simplex, 0);
    for (const NamedMeasure& measure : measures) {
      out += ' ';
      append_measure(out, measure.values[simplex]);
    }
    out += '\n';
  }
  return out;
}

}  // namespace delcert
