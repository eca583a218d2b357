#pragma once

#include <vector>

#include "kernel/perturb/parameters.hpp"
#include "kernel/perturb/simplex_walk.hpp"

namespace delcert {

/// Which labels have been perturbed already: 1 for these, else 0. Bytes, so that threads can mark different labels.
using PlacedLabels = std::vector<unsigned char>;

/// How many sampling radii away original points may have a say in what the candidates are.
[[nodiscard]] Rational reach_of_candidates(const PerturbationParameters& parameters);

/// A simplex whose diametric sphere may come within the tolerance of a perturbation of the point at hand.
template <int m>
struct Candidate {
  std::uint32_t vertex_count = 0;
  ViewSimplex<m> vertices{};   ///< positions in the view
  bool in_filter = false;      ///< whether the following two were computed by the filter
  Vector<Filter, m> centre{};  ///< relative to the first vertex
  Filter squared_radius{};
};

/// Whether a point is farther than t from a sphere of squared radius R², given its power P = d² − R² with respect to
/// it: |d − R| > t exactly when (P − t²)² > 4t²R² and (P > t² or R² > t²).
template <class S>
[[nodiscard]] Verdict is_farther(const S& power, const S& squared_radius, const S& squared_tolerance) {
  const S shifted = power - squared_tolerance;
  return conjunction(less(S(4) * squared_tolerance * squared_radius, square(shifted)),
                     disjunction(less(squared_tolerance, power), less(squared_tolerance, squared_radius)));
}

/// Finds the candidates of one label and tests positions against them.
template <int m>
class CandidateTest {
 public:
  /// References are kept.
  CandidateTest(const Atlas<m>& atlas, const PointSet<m>& points, const PlacedLabels& placed,
                const PerturbationParameters& parameters);

  /// Collects the candidates of label i. Precondition: a `FilterGuard` is alive.
  void prepare(Label i);

  /// Whether x (in the chart of i) is certainly farther than the tolerance from every candidate sphere of label i.
  /// A tie is decided; what stays undecided counts as too close.
  [[nodiscard]] bool accepts(const Vector<Rational, m>& x) const;

  [[nodiscard]] std::size_t candidate_count() const { return candidates_.size(); }
  [[nodiscard]] std::uint64_t visited() const { return visited_; }
  [[nodiscard]] const std::vector<Candidate<m>>& candidates() const { return candidates_; }
  [[nodiscard]] const PatchView<m>& view() const { return view_; }

 private:
  struct Collector;
  [[nodiscard]] bool is_far(const Candidate<m>& candidate, const Vector<Filter, m>& filter_x,
                            const Vector<Rational, m>& x) const;
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
  std::vector<Candidate<m>> candidates_;
  Rational squared_tolerance_;
  Filter filter_squared_tolerance_;
  std::uint64_t visited_ = 0;
};

}  // namespace delcert
