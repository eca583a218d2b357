#pragma once

#include <array>
#include <limits>
#include <vector>

#include "kernel/chart/label_range.hpp"
#include "kernel/stars/chart_complex.hpp"
#include "support/progress.hpp"

namespace delcert {

/// The flat metric d_PL of a complex, in which simplices are flat with geodesic edge lengths (level 6 of
/// docs/levels/space-forms.md).
struct PiecewiseFlatReport {
  /// Simplices of which it is not certain that a flat one with these edge lengths exists: in dimension 3, slivers.
  std::size_t unrealised = 0;
  std::size_t hinges = 0;        ///< (m−1)-faces between two simplices
  std::size_t not_delaunay = 0;  ///< those of which the filter says that they are not locally Delaunay
  std::size_t undecided = 0;     ///< those of which it cannot say
  /// Of the sums over the two simplices at a hinge: of the cotangents of the angles opposite to it on a surface, else
  /// of the heights of the circumcentres over it, laid out flat. Positive exactly where the hinge is locally Delaunay.
  double least_weight = 0;
  /// lower·d_PL ≤ d_M ≤ upper·d_PL along the natural map (Theorem 6X). 0 if it was not found, as where simplices are
  /// unrealised.
  double lower = 0;
  double upper = 0;

  /// 6a. Precondition: the dimension is 2.
  [[nodiscard]] bool is_self_delaunay() const {
    return hinges > 0 && unrealised == 0 && not_delaunay == 0 && undecided == 0;
  }
};

/// Measures the flat metric. `circumradius` bounds the geodesic circumradii (`ModelReport`); on the sphere it is less
/// than a right angle. Precondition: rounding to nearest; the stars agree.
template <int m>
[[nodiscard]] PiecewiseFlatReport measure_piecewise_flat(const Atlas<m>& atlas, const PointSet<m>& points,
                                                         const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                                         double circumradius, const Progress& progress);

/// What is measured of some simplices, without their facets.
struct FlatStretch {
  std::size_t simplices = 0;
  std::size_t unrealised = 0;
  int above = 0;  ///< the place of a bound, in a list of bounds that are tried
  int below = 0;
  bool is_complete = true;

  /// Takes over what was measured of others.
  void include(const FlatStretch& other);
};

/// A facet with the height of the circumcentre of one of its simplices over it, towards the opposite vertex; on a
/// surface in halves of the edge, which makes it the cotangent of the opposite angle.
template <int m>
struct FlatSide {
  std::array<std::uint32_t, static_cast<std::size_t>(m)> facet{};
  double lower = 0;
  double upper = 0;
};

/// What sides that are put together say of hinges.
struct HingeCount {
  std::size_t hinges = 0;
  std::size_t not_delaunay = 0;
  std::size_t undecided = 0;
  double least_weight = std::numeric_limits<double>::infinity();

  /// Takes over what is said of others.
  void include(const HingeCount& other);
};

template <int m>
struct FlatSimplices {
  FlatStretch stretch;
  HingeCount hinges;               ///< of the facets both of whose sides were measured
  std::vector<FlatSide<m>> sides;  ///< of the other facets, in no order
};

/// Measures the simplices that are first seen from some labels, for several processes to put together: facets between
/// simplices of two of them are counted by one that has the sides of both. Preconditions as above.
template <int m>
[[nodiscard]] FlatSimplices<m> measure_flat_simplices(const Atlas<m>& atlas, const PointSet<m>& points,
                                                      const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                                      LabelRange labels, const Progress& progress);
template <int m>
[[nodiscard]] HingeCount count_hinges(std::vector<FlatSide<m>> sides);
/// What follows of all simplices and all hinges.
[[nodiscard]] PiecewiseFlatReport piecewise_flat_report(const FlatStretch& stretch, const HingeCount& hinges,
                                                        Curvature curvature, double circumradius);

}  // namespace delcert
