#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/manifold/gluing/metric_field_atlas.hpp"
#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "kernel/stars/chart_complex.hpp"
#include "kernel/stars/star_complex.hpp"
#include "proofs/certificate/loop_search.hpp"

namespace delcert {

/// A complex as certificates state it (docs/certificate-format.md): every simplex once, with the lifts of its vertices,
/// and an edge path for each generator of the group.
template <int m>
struct PlacedComplex {
  /// Elements 1, 2, …: a vector of ℤᵐ, or the number of a parent and a letter. Element 0 is the identity.
  std::vector<std::vector<std::int32_t>> elements;
  /// Labels in increasing order, then the numbers of the elements of all but the first of them; sorted.
  std::vector<PlacedSimplex<m>> simplices;
  /// One for each generator: m translations of a torus; the generators of a space form, then, if it is flat, m
  /// translations. None on balls and metric fields.
  std::vector<std::vector<LoopStep>> loops;
};

/// Throw std::logic_error if a loop is not found or is not what it should be: then the complex is not connected, or
/// does not generate the group.
template <int m>
[[nodiscard]] PlacedComplex<m> placed_complex(const FlatAtlas<m>& atlas, const PointSet<m>& points,
                                              const StarComplex<m>& complex);
template <int m>
[[nodiscard]] PlacedComplex<m> placed_complex(const SpaceFormAtlas<m>& atlas, const ChartComplex<m>& complex);
template <int m>
[[nodiscard]] PlacedComplex<m> placed_complex(const MetricFieldAtlas<m>& atlas, const ChartComplex<m>& complex);

}  // namespace delcert
