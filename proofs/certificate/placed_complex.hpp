#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/manifold/flat_atlas.hpp"
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
  /// translations. None on balls, metric fields and submanifolds.
  std::vector<std::vector<LoopStep>> loops;
};

/// For each of these isometries, the letters of a group, an edge path of the complex from label 0 to label 0 along it,
/// compared exactly; none where none is found among so many places (`LoopSearch::find`). `points` are conformal
/// coordinates; `elements` are those of the simplices by their numbers, the identity first.
template <int m>
[[nodiscard]] std::vector<std::optional<std::vector<LoopStep>>> loops_along(
    const InvariantForm& form, const std::vector<Vector<Rational, m>>& points, const std::vector<FieldMatrix>& elements,
    const std::vector<FieldMatrix>& letters, const std::vector<PlacedSimplex<m>>& simplices,
    std::size_t most_places = 1000000);

/// Throw std::logic_error if a loop is not found or is not what it should be: then the complex is not connected, or
/// does not generate the group.
template <int m>
[[nodiscard]] PlacedComplex<m> placed_complex(const FlatAtlas<m>& atlas, const PointSet<m>& points,
                                              const StarComplex<m>& complex);
template <int m>
[[nodiscard]] PlacedComplex<m> placed_complex(const SpaceFormAtlas<m>& atlas, const ChartComplex<m>& complex);
/// The same where sightings have no elements, only shifts: of metric fields and submanifolds.
template <int m>
[[nodiscard]] PlacedComplex<m> placed_complex(const ChartComplex<m>& complex);

}  // namespace delcert
