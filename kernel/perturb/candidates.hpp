#pragma once

#include <functional>
#include <vector>

#include "kernel/perturb/parameters.hpp"
#include "kernel/perturb/rounded_walk.hpp"

namespace delcert {

/// Which labels have been perturbed already: 1 for these, else 0. Bytes, so that threads can mark different labels.
using PlacedLabels = std::vector<unsigned char>;

/// How many sampling radii away original points may have a say in what the candidates are.
[[nodiscard]] Rational reach_of_candidates(const PerturbationParameters& parameters);

/// A simplex whose diametric sphere may come within the tolerance of a perturbation of the point at hand.
template <int m>
struct Candidate {
  std::uint32_t vertex_count = 0;
  ViewSimplex<m> vertices{};  ///< positions in the view
  /// In the coordinates of `CandidateTest::frame`, relative to the first vertex; without error bounds unless
  /// `is_bounded`: then the bounds of `CandidateTest` hold, by the number of vertices. The weight is 0 if nothing is
  /// known.
  SphereForm<double, m> sphere;
  bool is_bounded = false;
};

/// Whether a point is farther than t from a sphere of squared radius R², given its power P = d² − R² with respect to
/// it: |d − R| > t exactly when (P − t²)² > 4t²R² and (P > t² or R² > t²).
template <class S>
[[nodiscard]] Verdict is_farther(const S& power, const S& squared_radius, const S& squared_tolerance) {
  const S shifted = power - squared_tolerance;
  return conjunction(less(S(4) * squared_tolerance * squared_radius, square(shifted)),
                     disjunction(less(squared_tolerance, power), less(squared_tolerance, squared_radius)));
}

/// Another point that the chart of a label shows.
template <int m>
struct PointAround {
  Vector<double, m> at;    ///< in the coordinates of `CandidateTest::frame`, without error bounds
  bool is_placed = false;  ///< otherwise it is where it was originally
};

/// Finds the candidates of one label and tests positions against them.
template <int m>
class CandidateTest {
 public:
  /// References are kept.
  CandidateTest(const Atlas<m>& atlas, const PointSet<m>& points, const PlacedLabels& placed,
                const PerturbationParameters& parameters);

  /// From now on `prepare` also finds the points around, within so many sampling radii.
  void look_around(const Rational& reach) { reach_around_ = reach; }

  /// All on intervals, for comparison; otherwise doubles with bounds come first (docs/rounded-spheres.md).
  void use_intervals_only() { uses_doubles_ = false; }

  /// Collects the candidates of label i. Precondition: a `FilterGuard` is alive.
  // Not inlined where the guard begins or ends: a compiler might compute doubles to choose by on its other side.
  [[gnu::noinline]] void prepare(Label i);

  /// Whether x (in the chart of i) is certainly farther than the tolerance from every candidate sphere of label i.
  /// A tie is decided; what stays undecided counts as too close.
  [[nodiscard]] bool accepts(const Vector<Rational, m>& x) const;
  /// The same for a point in this enclosure, which is asked for exactly where that does not decide.
  [[nodiscard]] bool accepts(const Vector<Filter, m>& enclosure,
                             const std::function<Vector<Rational, m>()>& exactly) const;

  [[nodiscard]] std::size_t candidate_count() const { return candidates_.size(); }
  [[nodiscard]] std::uint64_t visited() const { return visited_; }
  [[nodiscard]] const std::vector<Candidate<m>>& candidates() const { return candidates_; }
  [[nodiscard]] const PatchView<m>& view() const { return view_; }
  /// About the original point, in a unit of about the edge bound.
  [[nodiscard]] const RoundedFrame<m>& frame() const { return frame_; }
  /// The other points whose originals are within `reach`, if that was asked for.
  [[nodiscard]] const std::vector<PointAround<m>>& around() const { return around_; }
  /// Where positions of the view are there.
  [[nodiscard]] const std::vector<Vector<double, m>>& places() const { return places_.at; }

 private:
  struct Collector;
  /// What lengths are in a sampling radius.
  struct Lengths {
    Rational unit{0};
    double reach_of_sightings = 0;
    double reach_around = 0;
    Filter squared_reach{};
    Filter squared_edge_bound{};
    Rational reach_of_spheres;
    Rational squared_reach_of_spheres;
    Filter filter_squared_reach_of_spheres{};
    Rational squared_circumradius_bound;
    Filter filter_squared_circumradius_bound{};
    double far_power = 0;
    Rational squared_tolerance;
    Filter filter_squared_tolerance{};
    // In the unit of the frame, with their errors.
    double scaled_reach_of_spheres = 0;
    RoundingBound bound_of_reach_of_spheres;
    double scaled_circumradius_bound = 0;
    RoundingBound bound_of_circumradius_bound;
    double scaled_tolerance = 0;
    RoundingBound bound_of_tolerance;
    double largest_offset = 0;  // of a perturbation from the original point, in the unit of the frame
  };
  void measure_in(const Rational& unit);
  /// Fills view_ and around_.
  void look(Label i);
  [[nodiscard]] bool is_pruned() const { return parameters_.candidates == CandidateRule::pruned; }
  /// Fills places_, and bounds_ where doubles are of use: in low dimension, where edges are bounded.
  void look_in_doubles();
  void connect();
  void bound_gaps();
  /// Undecided without a bound.
  [[nodiscard]] Verdict is_far_in_doubles(const Candidate<m>& candidate, const Vector<double, m>& x) const;
  [[nodiscard]] Verdict is_far_in_filter(const Candidate<m>& candidate, const Vector<Filter, m>& x) const;
  template <class S>
  [[nodiscard]] Verdict is_far_in(const Candidate<m>& candidate, const Vector<Rational, m>& x) const;

  const Atlas<m>& atlas_;
  const PointSet<m>& points_;
  const PlacedLabels& placed_;
  PerturbationParameters parameters_;
  MetricOn<Filter, m> filter_;
  MetricOn<Rational, m> exact_;
  PatchView<m> view_;
  std::vector<Sighting<m>> seen_;
  std::vector<Sighting<m>> seen_near_;
  std::vector<Candidate<m>> candidates_;
  std::optional<Rational> reach_around_;
  std::vector<PointAround<m>> around_;
  RoundedFrame<m> frame_;
  RoundedPlaces<m> places_;
  std::optional<RoundedBounds<m>> bounds_;  // of the places; none if all is done on intervals
  double bounded_size_ = 0;                 // of the places for which the bounds were computed
  double bounded_error_ = 0;
  bool in_doubles_ = false;  // the label at hand
  // By vertex count: at the original point, and at perturbations of it.
  std::array<double, static_cast<std::size_t>(m) + 2> radius_errors_{};
  std::array<std::optional<SphereGap<RoundingBound>>, static_cast<std::size_t>(m) + 2> centre_gap_bounds_;
  std::array<std::optional<SphereGap<RoundingBound>>, static_cast<std::size_t>(m) + 2> gap_bounds_;
  Lengths lengths_;
  bool uses_doubles_ = true;
  double error_of_x_ = 0;  // up to which positions in the frame are decided about in doubles
  std::uint64_t visited_ = 0;
};

}  // namespace delcert
