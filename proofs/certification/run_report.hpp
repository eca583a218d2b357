#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernel/manifold/gluing/gluing_check.hpp"
#include "kernel/manifold/input_check.hpp"
#include "kernel/perturb/placement.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "kernel/theorems/piecewise_flat.hpp"
#include "kernel/theorems/reach_bound.hpp"
#include "kernel/theorems/riemannian_simplices.hpp"
#include "proofs/certificate/metric_field_claims.hpp"
#include "proofs/certificate/run_parameters.hpp"
#include "proofs/certificate/space_form_distortion.hpp"
#include "proofs/certification/stage_clock.hpp"

namespace delcert {

/// What `delcert certify` says of a run, for people and for programs. What a family does not have is empty and is not
/// mentioned.
struct RunReport {
  /// Of a space form.
  struct Group {
    int curvature = 0;
    Rational injectivity_radius;  ///< a lower bound
    std::string first_homology;
  };
  /// Of a metric field.
  struct Metric {
    EigenvalueBounds eigenvalues;
    ChartDistortion distortion;
  };
  /// Of an atlas by formulas.
  struct Gluing {
    std::size_t charts = 0;
    std::size_t transitions = 0;
    GluingReport cells;
    Rational distortion;  ///< of the transitions, an upper bound
  };
  /// Of a submanifold.
  struct Graphs {
    std::size_t ambient_dimension = 0;
    Rational slope;                   ///< of the manifold in its charts, an upper bound
    Rational distortion;              ///< of the transitions, an upper bound
    std::uint64_t cover_parts = 0;    ///< of the box, to show that the charts are all of it
    std::optional<double> margin;     ///< of level 5i, a lower bound; if 5i is asked for and level 5 is reached
    std::optional<ReachBound> reach;  ///< of a zero set; once its complex has been looked at for level 4
  };
  /// Of sampling radii that vary.
  struct Radii {
    Rational least;
    Rational variation;           ///< ε₀, an upper bound
    std::string reach;            ///< of labels how far apart that is measured, for people
    double points_uniformly = 0;  ///< about how many the least radius alone would need
  };
  /// Stars before any repair.
  struct FirstStars {
    std::size_t failures = 0;
    std::size_t disagreeing = 0;  ///< with the star of another label
  };

  std::string manifold;
  std::string family;  ///< as in certificates
  Dimension dimension{0};
  std::optional<Group> group;
  std::optional<Metric> metric;
  std::optional<Gluing> gluing;
  std::optional<Graphs> graphs;
  std::optional<Radii> radii;
  RunParameters parameters;
  Rational sampling_radius;
  std::optional<Rational> patch_factor;  ///< the radius of patches, in sampling radii
  std::size_t points = 0;
  std::size_t simplices = 0;
  std::vector<InputItem> input;
  PerturbationStatistics statistics;
  std::optional<FirstStars> first;
  int repair_rounds = 0;
  int refinement_rounds = 0;
  std::size_t repaired_points = 0;
  Claims claims;
  std::vector<std::string> reasons;  ///< for levels that were asked for and not reached
  std::optional<StarStability> stability;
  std::optional<PiecewiseFlatReport> flat;
  std::optional<RiemannianSimplices> riemannian;
  std::optional<SpaceFormDistortion> distortion;
  std::vector<StageClock::Stage> stages;
  double peak_memory_mib = 0;
  std::string certificate;                ///< the file
  std::shared_ptr<const void> made_from;  ///< the whole run: taking it apart takes time, too

  template <class Run>
  void take(const Run& run) {
    simplices = run.complex.simplices().size();
    statistics = run.statistics;
    repair_rounds = run.repair_rounds;
    repaired_points = run.repaired_points;
  }
};

/// Precondition: these radii vary.
[[nodiscard]] RunReport::Radii radii_report(const SamplingRadii& radii, const Rational& variation, Dimension dimension,
                                            std::string reach);

/// A page of text. Decimal figures in it are rounded in the safe direction and marked by ≥ or ≤.
[[nodiscard]] std::string report_text(const RunReport& report);

}  // namespace delcert
