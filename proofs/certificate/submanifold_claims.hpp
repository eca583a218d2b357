#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/manifold/submanifold/submanifold_atlas.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "kernel/theorems/graph_isotopy.hpp"
#include "kernel/theorems/reach_bound.hpp"
#include "kernel/theorems/restricted_delaunay.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/run_parameters.hpp"

namespace delcert {

/// What is measured of a certified run beyond levels 1 and 2.
template <int m>
struct SubmanifoldMeasures {
  std::optional<StarStability> stability;  ///< level 2s, if that is selected
  GraphTriangulation<m> triangulation;     ///< level 5
  std::optional<GraphIsotopy> isotopy;     ///< level 5i, if that is selected and level 5 holds
  /// Level 4, if level 5 holds.
  struct Delaunay {
    Rational density;
    RestrictedDelaunay extrinsic;
    RestrictedDelaunay intrinsic;
  };
  std::optional<Delaunay> delaunay;
  std::optional<ReachBound> reach;  ///< of a zero set, with level 4: it is in no certificate
  double weight = 0;                ///< of surfaces: a lower bound of the sums of the cotangents opposite to edges
};

/// Measures a certified run for those levels that are selected.
template <int m>
[[nodiscard]] SubmanifoldMeasures<m> measure_submanifold(const SubmanifoldAtlas<m>& atlas, const ChartRun<m>& run,
                                                         const ModelGeometry& geometry, const LevelSelection& selection,
                                                         const Progress& progress);

/// Derives the levels from a certified run and its measures, checking the inequalities of docs/certificate-format.md
/// on the way; reasons for levels that were selected and are not reached are appended to `reasons`.
template <int m>
[[nodiscard]] Claims derive_claims(const SubmanifoldAtlas<m>& atlas, const RunParameters& parameters,
                                   const ChartRun<m>& run, const SubmanifoldMeasures<m>& measures,
                                   const LevelSelection& selection, std::vector<std::string>& reasons);

/// Levels 5 and, if it was measured, 5i, of vertices that are on M or given; without the level below nothing is
/// claimed.
template <int m>
void claim_graph(const GraphTriangulation<m>& triangulation, const std::optional<GraphIsotopy>& isotopy,
                 const Rational& unit, const LevelSelection& selection, Claims& claims,
                 std::vector<std::string>& reasons);

}  // namespace delcert
