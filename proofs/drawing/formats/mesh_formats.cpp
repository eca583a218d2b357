#include "proofs/drawing/formats/mesh_formats.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "proofs/drawing/formats/cell_data.hpp"
#include "proofs/drawing/formats/number_text.hpp"

namespace delcert {

namespace {

/// Text to which much is appended.
class MeshText {
 public:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
  }
  /// A number and a character after it.
  template <class Number>
  void number(Number value, char after) {
    append_number(text, value);
    text += after;
  }
  void measure(double value, char after) {
    append_measure(text, value);
    text += after;
  }
  void point(const Drawing& drawing, std::size_t vertex, char after) {
    const auto [x, y, z] = space_point(drawing, vertex);
    number(x, ' ');
    number(y, ' ');
    number(z, after);
  }
  void corners(const Drawing& drawing, std::size_t simplex, std::uint32_t first, char after) {
    const std::size_t size = drawing.dimension + 1;
    for (std::size_t k = 0; k < size; ++k)
      number(drawing.simplices[simplex * size + k] + first, k + 1 < size ? ' ' : after);
  }

  std::string text;
};

/// Two hyphens end a comment of XML.
std::string without_double_hyphens(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at)) text.replace(at, 2, "- -");
  return text;
}

void begin_array(MeshText& out, std::string_view type, std::string_view name, std::size_t components) {
  out.add("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type, name, components);
}
void end_array(MeshText& out) { out.add("\n</DataArray>\n"); }

template <class Numbers>
void append_array(MeshText& out, std::string_view type, std::string_view name, const Numbers& numbers) {
  begin_array(out, type, name, 1);
  for (const auto& number : numbers) out.number(number, ' ');
  end_array(out);
}

}  // namespace

std::string vtu_text(const ExportContent& content) {
  const Drawing& drawing = *content.drawing;
  constexpr std::array<int, 4> types{1, 3, 5, 10};
  const std::size_t size = drawing.dimension + 1;
  MeshText out;
  out.add("<?xml version=\"1.0\"?>\n<!-- {} -->\n",
          without_double_hyphens(comment_lines("", content.origin(), lift_lines(drawing))));
  out.add("<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n");
  if (!drawing.matching_faces.empty()) {
    out.add(
        "<FieldData>\n<DataArray type=\"Int64\" Name=\"matching_faces\" NumberOfComponents=\"{}\" "
        "NumberOfTuples=\"{}\" format=\"ascii\">\n",
        2 * drawing.dimension, drawing.matching_faces.size());
    for (const MatchingFaces& pair : drawing.matching_faces) {
      for (const std::uint32_t vertex : pair.first) out.number(vertex, ' ');
      for (const std::uint32_t vertex : pair.second) out.number(vertex, ' ');
      out.add("\n");
    }
    out.add("</DataArray>\n</FieldData>\n");
  }
  out.add("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n", drawing.vertex_count(),
          drawing.simplex_count());
  append_array(out, "Int64", "label", drawing.labels);
  append_array(out, "Int64", "lift", drawing.lifts);
  out.add("</PointData>\n<CellData>\n");
  append_array(out, "Int64", "position", drawing.positions);
  for (const NamedMeasure& measure : named_measures(drawing)) {
    begin_array(out, "Float64", measure.name, 1);
    for (const double value : measure.values) out.measure(value, ' ');
    end_array(out);
  }
  out.add("</CellData>\n<Points>\n");
  begin_array(out, "Float64", "Points", 3);
  for (std::size_t vertex = 0; vertex < drawing.vertex_count(); ++vertex) {
    out.point(drawing, vertex, '\n');
  }
  end_array(out);
  out.add("</Points>\n<Cells>\n");
  begin_array(out, "Int64", "connectivity", 1);
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    out.corners(drawing, simplex, 0, '\n');
  }
  end_array(out);
  begin_array(out, "Int64", "offsets", 1);
  for (std::size_t simplex = 1; simplex <= drawing.simplex_count(); ++simplex) out.number(simplex * size, ' ');
  end_array(out);
  begin_array(out, "UInt8", "types", 1);
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) out.number(types[drawing.dimension], ' ');
  end_array(out);
  out.add("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  return std::move(out.text);
}

std::string medit_text(const ExportContent& content) {
  const Drawing& drawing = *content.drawing;
  constexpr std::array<std::string_view, 4> names{"", "Edges", "Triangles", "Tetrahedra"};
  MeshText out;
  out.add("MeshVersionFormatted 2\n{}\nDimension 3\n\nVertices\n{}\n",
          comment_lines("# ", content.origin(), lift_lines(drawing)), drawing.vertex_count());
  for (std::size_t vertex = 0; vertex < drawing.vertex_count(); ++vertex) {
    out.point(drawing, vertex, ' ');
    out.number(drawing.labels[vertex], '\n');
  }
  out.add("\n{}\n{}\n", names[drawing.dimension], drawing.simplex_count());
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    out.corners(drawing, simplex, 1, ' ');
    out.number(drawing.positions[simplex], '\n');
  }
  out.add("\nEnd\n");
  return std::move(out.text);
}

std::string gmsh_text(const ExportContent& content) {
  const Drawing& drawing = *content.drawing;
  constexpr std::array<int, 4> types{15, 1, 2, 4};
  MeshText out;
  out.add("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n{}$EndComments\n$Nodes\n{}\n",
          comment_lines("", content.origin(), lift_lines(drawing)), drawing.vertex_count());
  for (std::size_t vertex = 0; vertex < drawing.vertex_count(); ++vertex) {
    out.number(vertex + 1, ' ');
    out.point(drawing, vertex, '\n');
  }
  out.add("$EndNodes\n$Elements\n{}\n", drawing.simplex_count());
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    out.number(simplex + 1, ' ');
    out.number(types[drawing.dimension], ' ');
    out.text += "2 1 1 ";
    out.corners(drawing, simplex, 1, '\n');
  }
  out.add("$EndElements\n");
  const auto begin_data = [&out](std::string_view section, std::string_view name, std::size_t count) {
    out.add("${}\n1\n\"{}\"\n1\n0\n3\n0\n1\n{}\n", section, name, count);
  };
  for (const auto& [name, numbers] :
       {std::pair<std::string_view, const std::vector<std::uint32_t>&>{"label", drawing.labels},
        {"lift", drawing.lifts}}) {
    begin_data("NodeData", name, numbers.size());
    for (std::size_t vertex = 0; vertex < numbers.size(); ++vertex) {
      out.number(vertex + 1, ' ');
      out.number(numbers[vertex], '\n');
    }
    out.add("$EndNodeData\n");
  }
  for (const NamedMeasure& measure : named_measures(drawing)) {
    begin_data("ElementData", measure.name, measure.values.size());
    for (std::size_t simplex = 0; simplex < measure.values.size(); ++simplex) {
      out.number(simplex + 1, ' ');
      out.measure(measure.values[simplex], '\n');
    }
    out.add("$EndElementData\n");
  }
  return std::move(out.text);
}

std::string csv_text(const ExportContent& content) {
  const Drawing& drawing = *content.drawing;
  const std::size_t size = drawing.dimension + 1;
  const std::vector<NamedMeasure> measures = named_measures(drawing);
  MeshText out;
  out.add("{}", comment_lines("# ", content.origin(), {}));
  out.add("position");
  for (std::size_t k = 0; k < size; ++k) out.add(",label_{}", k);
  for (std::size_t k = 0; k < size; ++k) out.add(",lift_{}", k);
  for (const NamedMeasure& measure : measures) out.add(",{}", measure.name);
  out.add("\n");
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) {
    append_number(out.text, drawing.positions[simplex]);
    for (std::size_t k = 0; k < size; ++k) {
      out.text += ',';
      append_number(out.text, drawing.labels[drawing.simplices[simplex * size + k]]);
    }
    for (std::size_t k = 0; k < size; ++k) {
      out.text += ',';
      out.text += drawing.lift_texts[drawing.lifts[drawing.simplices[simplex * size + k]]];
    }
    for (const NamedMeasure& measure : measures) {
      out.text += ',';
      append_measure(out.text, measure.values[simplex]);
    }
    out.text += '\n';
  }
  return std::move(out.text);
}

}  // namespace delcert
