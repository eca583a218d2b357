#pragma once

#include "kernel/ranks/shared_perturbation.hpp"
#include "kernel/run/chart_run.hpp"

namespace delcert {

/// What a rank has of a run that all of them have made together.
template <int m>
struct SharedRun {
  PointSet<m> points;       ///< of the labels here
  ChartComplex<m> complex;  ///< the stars of own labels and of the labels that these name, which alone are interior
  ModelGeometry geometry;   ///< with what is known of the whole
  // Of the whole, the same everywhere:
  LocalMargins margins;
  ModelReport model;
  int repair_rounds = 0;
  std::size_t repaired_points = 0;
  std::uint32_t colours = 0;
  // Of this rank:
  PerturbationStatistics statistics;
  std::uint64_t bytes_sent = 0;
};

/// What `run_in_charts` does, by several ranks, with the same result: every rank places its own labels, computes their
/// stars and certifies them; stars are compared where they meet; what fails is repaired, round by round.
///
/// Throws Rejection, with the labels by their names, at the first rank, if something still fails at last; other errors
/// where they occur. Preconditions: the atlas is of the labels here, which are complete within its patches about own
/// labels; all radii are the same; rounding to nearest.
template <int m>
[[nodiscard]] SharedRun<m> run_shared(Communicator& ranks, const LabelsHere& labels, const Atlas<m>& atlas,
                                      const ModelGeometry& geometry, const PerturbationParameters& parameters,
                                      const RunRequest& request, BlockLog* log, const Progress& progress);

}  // namespace delcert
