#pragma once

#include <string>

#include "proofs/drawing/drawing.hpp"
#include "proofs/drawing/figure/figure.hpp"

namespace delcert {

struct PictureOptions {
  /// Whether the star of a label with the least protection, or, where that is not known, thickness, is marked.
  bool has_worst_star = false;
  /// Whether there is a bar of a round length; on what has lengths that are the same everywhere: flat manifolds,
  /// spheres and submanifolds, of the latter in the middle.
  bool has_scale = false;
  /// By which of `named_measures` triangles are shaded, the greater the darker: thickness in parts of the greatest that
  /// there is of any triangle, all others in parts of the greatest of this drawing.
  std::string measure = "thickness";
};

/// A drawing of a complex of dimension 1 or 2: its triangles, shaded by a measure, or its edges with their vertices,
/// and the outline of the fundamental domain. Of a surface in space the triangles that are seen from the end of the
/// third axis, the nearest last; of a curve in space all edges, with a gap in what is behind where two cross. Made in
/// doubles, for the eye. Throws InputError in other dimensions, and for a measure that is not there.
[[nodiscard]] Figure picture_of(const Drawing& drawing, const PictureOptions& options = {});

/// The same as SVG.
[[nodiscard]] std::string picture_svg(const Drawing& drawing, const PictureOptions& options = {});

/// The position of the worst simplex of a drawing: of the least protection, or, where no protection is known, of the
/// least thickness. None where nothing was measured.
[[nodiscard]] std::optional<std::size_t> worst_simplex(const Drawing& drawing);

}  // namespace delcert
