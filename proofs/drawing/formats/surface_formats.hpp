#pragma once

#include "proofs/drawing/formats/export_format.hpp"

namespace delcert {

// Triangles in space: of two-dimensional complexes. Vertices and triangles in the order of the drawing.

/// Object File Format; labels and measures are not in it.
[[nodiscard]] std::string off_text(const ExportContent& content);
/// Wavefront's; labels and measures are not in it.
[[nodiscard]] std::string obj_text(const ExportContent& content);
/// Stanford's, in ASCII, with labels, lifts and measures.
[[nodiscard]] std::string ply_text(const ExportContent& content);

}  // namespace delcert
