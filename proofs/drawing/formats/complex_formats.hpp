#pragma once

#include "proofs/drawing/formats/export_format.hpp"

namespace delcert {

// The complex alone, without coordinates. Vertices are numbered in the order of their labels.

/// The most simplices of which a signature is computed: it takes as long as their square.
inline constexpr std::size_t most_simplices_of_a_signature = 2000;

/// What GUDHI's Simplex_tree reads: a line for each face, its dimension, its labels in increasing order and the
/// filtration value 0; faces before what they are faces of. The format has no comments.
[[nodiscard]] std::string simplex_tree_text(const ExportContent& content);
/// Regina's data file (XML, uncompressed), a triangulation by gluings; dimensions 2 to 4.
[[nodiscard]] std::string regina_text(const ExportContent& content);
/// Regina's isomorphism signature, dimensions 2 to 4, and a line feed. Throws InputError for more than
/// `most_simplices_of_a_signature` simplices, and for what is not connected.
[[nodiscard]] std::string isosig_text(const ExportContent& content);
/// SnapPea's triangulation file, vertices finite; oriented. Throws InputError for what cannot be oriented or has a
/// boundary.
[[nodiscard]] std::string snappea_text(const ExportContent& content);

}  // namespace delcert
