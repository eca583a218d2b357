#include "proofs/drawing/formats/export_format.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "proofs/drawing/formats/complex_formats.hpp"
#include "proofs/drawing/formats/drawing_json.hpp"
#include "proofs/drawing/formats/lattice_format.hpp"
#include "proofs/drawing/formats/mesh_formats.hpp"
#include "proofs/drawing/formats/surface_formats.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"

namespace delcert {

namespace {

void require_dimension(const CertificateSummary& certificate, int least, int greatest, const char* format) {
  const int m = certificate.manifold.dimension.value;
  if (least <= m && m <= greatest) return;
  throw InputError(fmt::format("{} holds complexes of dimension {}, and this one has dimension {}", format,
                               least == greatest ? std::to_string(least) : fmt::format("{} to {}", least, greatest),
                               m));
}

void check_nothing(const CertificateSummary&) {}

std::string json_text(const ExportContent& content) {
  return drawing_json(content.certificate, *content.drawing, content.verification, content.is_exact);
}

}  // namespace

std::string ExportContent::origin() const {
  std::string result = origin_text(certificate, verification);
  if (drawing != nullptr) result += "; coordinates and measures are approximate";
  return result + (note.empty() ? "" : "; " + note);
}

const std::vector<ExportFormat>& export_formats() {
  using Summary = const CertificateSummary&;
  static const std::vector<ExportFormat> formats{
      {"json", "the whole drawing, with measures and matching faces", true, true, check_nothing, json_text},
      {"vtu", "VTK's unstructured grid (ParaView)", true, true, [](Summary c) { require_dimension(c, 1, 3, "vtu"); },
       vtu_text},
      {"medit", "Medit's mesh", true, false, [](Summary c) { require_dimension(c, 1, 3, "medit"); }, medit_text},
      {"gmsh", "Gmsh's mesh, version 2.2", true, true, [](Summary c) { require_dimension(c, 1, 3, "gmsh"); },
       gmsh_text},
      {"off", "Object File Format, triangles in space", true, false,
       [](Summary c) { require_dimension(c, 2, 2, "off"); }, off_text},
      {"obj", "Wavefront's triangles in space", true, false, [](Summary c) { require_dimension(c, 2, 2, "obj"); },
       obj_text},
      {"ply", "Stanford's triangles in space, with measures", true, true,
       [](Summary c) { require_dimension(c, 2, 2, "ply"); }, ply_text},
      {"csv", "a table of simplices with their measures", true, true, check_nothing, csv_text},
      {"simplex-tree", "GUDHI's list of faces", false, false, check_nothing, simplex_tree_text},
      {"regina", "Regina's data file", false, false, [](Summary c) { require_dimension(c, 2, 4, "regina"); },
       regina_text},
      {"isosig", "Regina's isomorphism signature", false, false,
       [](Summary c) { require_dimension(c, 2, 4, "isosig"); }, isosig_text},
      {"snappea", "SnapPea's triangulation file", false, false,
       [](Summary c) { require_dimension(c, 3, 3, "snappea"); }, snappea_text},
      {"lattice", "a flat torus in integers, exactly (delcert-verified)", false, false, require_lattice, lattice_text},
  };
  return formats;
}

const ExportFormat& export_format(std::string_view name) {
  std::vector<std::string_view> names;
  for (const ExportFormat& format : export_formats()) {
    if (format.name == name) return format;
    names.push_back(format.name);
  }
  std::string list;
  for (const std::string_view known : names) list += (list.empty() ? "" : ", ") + std::string(known);
  throw std::invalid_argument("no format " + shortened(name) + suggestion(name, names) + " (formats: " + list + ")");
}

}  // namespace delcert
