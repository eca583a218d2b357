#pragma once

#include <vector>

#include "kernel/ranks/part_of_net.hpp"
#include "kernel/ranks/shared_run.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "kernel/theorems/piecewise_flat.hpp"
#include "kernel/theorems/riemannian_simplices.hpp"

namespace delcert {

// What is measured of the whole, by ranks that measure what is theirs; the same everywhere, and the same as in one
// process. Preconditions: those of the functions for one process; rounding to nearest.

/// As `measure_separation`.
template <int m>
[[nodiscard]] Rational shared_separation(Communicator& ranks, const LabelsHere& labels, const Atlas<m>& atlas,
                                         const Progress& progress);

/// As `check_stability`, where charts are not isometric; labels of failures are names, and reasons are left out.
template <int m>
[[nodiscard]] StarStability shared_stability(Communicator& ranks, const LabelsHere& labels, const Atlas<m>& atlas,
                                             const SharedRun<m>& run, const Progress& progress);

/// As `measure_riemannian_simplices`.
template <int m>
[[nodiscard]] RiemannianSimplices shared_riemannian_simplices(Communicator& ranks, const LabelsHere& labels,
                                                              const Atlas<m>& atlas, const SharedRun<m>& run,
                                                              const Progress& progress);

/// As `measure_piecewise_flat`. The sides of a facet meet at the rank of its least label.
template <int m>
[[nodiscard]] PiecewiseFlatReport shared_piecewise_flat(Communicator& ranks, const LabelsHere& labels,
                                                        const Atlas<m>& atlas, const SharedRun<m>& run,
                                                        const Progress& progress);

/// Of the whole complex.
struct ComplexCount {
  std::uint64_t simplices = 0;
  std::int64_t euler_characteristic = 0;
};
/// Faces are counted at their least labels.
template <int m>
[[nodiscard]] ComplexCount shared_count(Communicator& ranks, const LabelsHere& labels, const ChartComplex<m>& complex);

}  // namespace delcert
