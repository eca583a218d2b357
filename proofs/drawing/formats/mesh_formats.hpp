#pragma once

#include "proofs/drawing/formats/export_format.hpp"

namespace delcert {

// Simplices of dimension 1 to 3, with labels, lifts and measures as far as the format has room for them.

/// VTK's XML for unstructured grids, in ASCII, with the pairs of matching faces as field data.
[[nodiscard]] std::string vtu_text(const ExportContent& content);
/// Medit's, the reference of a vertex its label, that of a simplex its position in the certificate.
[[nodiscard]] std::string medit_text(const ExportContent& content);
/// Gmsh's, version 2.2, in ASCII.
[[nodiscard]] std::string gmsh_text(const ExportContent& content);
/// A table with a line for each simplex: labels, lifts, measures. Of any dimension.
[[nodiscard]] std::string csv_text(const ExportContent& content);

}  // namespace delcert
