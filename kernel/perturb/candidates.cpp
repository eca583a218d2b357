#include "kernel/perturb/candidates.hpp"

#include <limits>
#include <optional>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

/// Collects the simplices whose sphere meets the ball of all perturbations, widened by the tolerance.
template <int m>
struct CandidateTest<m>::Collector {
  static constexpr bool visits_top = false;

  CandidateTest* test;
  std::size_t least_vertices;
  std::optional<Rational> squared_radius_bound;
  std::optional<Filter> filter_squared_radius_bound;
  Vector<Rational, m> centre;  // the original point
  Vector<Filter, m> filter_centre;
  Rational squared_reach;  // (ρ₀ + tolerance)²ε², the tolerance being the larger of both
  Filter filter_squared_reach;
  double far_power = std::numeric_limits<double>::infinity();  // s(2ϱ + s), rounded up; infinite without a bound

  Vector<Filter, m> filter_offset;  // from the first vertex to the original point
  Filter filter_squared_offset;
  Vector<Rational, m> exact_offset;
  typename SphereStack<Filter, m>::Probe probe;

  template <class S>
  void start(const Vector<S, m>& origin) {
    if constexpr (std::same_as<S, Filter>) {
      filter_offset = difference(filter_centre, origin);
      filter_squared_offset = test->filter_.squared_norm(filter_offset);
    } else {
      exact_offset = difference(centre, origin);
    }
  }

  /// Whether the sphere is out of reach s whatever its radius below the bound ϱ is: |d − R| ≤ s gives
  /// |P| = |d − R|(d + R) ≤ s(2ϱ + s). Saves the products of `is_farther` for most spheres.
  [[nodiscard]] bool is_certainly_far(const Filter& power) const {
    return power.lower() > far_power || power.upper() < -far_power;
  }

  bool enter(const SphereStack<Filter, m>& stack, std::span<const std::uint32_t> vertices) {
    ++test->visited_;
    if (filter_squared_radius_bound && is_refuted(less(stack.squared_radius(), *filter_squared_radius_bound))) {
      return false;
    }
    if (vertices.size() < least_vertices) return true;
    const Filter power = stack.power(filter_offset, filter_squared_offset);
    if (is_proved(is_farther(power, stack.squared_radius(), filter_squared_reach))) return true;
    add(vertices);
    Candidate<m>& candidate = test->candidates_.back();
    candidate.in_filter = true;
    candidate.centre = stack.centre();
    candidate.squared_radius = stack.squared_radius();
    return true;
  }

  void facet(const SphereStack<Filter, m>& stack) { probe = stack.probe(filter_offset, filter_squared_offset); }

  void over(const SphereStack<Filter, m>& stack, const typename SphereStack<Filter, m>::Apex& apex,
            std::span<const std::uint32_t> vertices) {
    ++test->visited_;
    if (filter_squared_radius_bound && is_refuted(less(apex.squared_radius, *filter_squared_radius_bound))) return;
    const Filter power = SphereStack<Filter, m>::power_over(apex, probe);
    if (is_certainly_far(power) || is_proved(is_farther(power, apex.squared_radius, filter_squared_reach))) return;
    add(vertices);
    Candidate<m>& candidate = test->candidates_.back();
    candidate.in_filter = true;
    candidate.centre = stack.centre_over(apex);
    candidate.squared_radius = apex.squared_radius;
  }

  bool enter(const SphereStack<Rational, m>& stack, std::span<const std::uint32_t> vertices) {
    ++test->visited_;
    if (squared_radius_bound && stack.squared_radius() >= *squared_radius_bound) return false;
    if (vertices.size() < least_vertices) return true;
    const Rational power = stack.power(exact_offset, test->exact_.squared_norm(exact_offset));
    if (is_proved(is_farther(power, stack.squared_radius(), squared_reach))) return true;
    add(vertices);
    return true;
  }

  /// A degenerate simplex is no facet of a forbidden configuration (its facets are good) and has no diametric sphere.
  void degenerate(std::span<const std::uint32_t>) {}

  void add(std::span<const std::uint32_t> vertices) {
    Candidate<m> candidate;
    candidate.vertex_count = static_cast<std::uint32_t>(vertices.size());
    std::copy(vertices.begin(), vertices.end(), candidate.vertices.begin());
    test->candidates_.push_back(candidate);
  }
};

namespace {

template <int m>
MetricOn<Filter, m> filter_metric(const Atlas<m>& atlas) {
  const FilterGuard guard;
  return atlas.metric().template on<Filter>();
}

/// The same where perturbed points are now. Pruned: what is within the edge bound of some perturbation of p_i.
/// Otherwise the labels of the paper's 𝒮_i, which are those of the original points in a ball.
Rational reach_in_place(const PerturbationParameters& parameters) {
  if (parameters.candidates == CandidateRule::pruned) return parameters.edge_bound + parameters.perturbation;
  return Rational(5) + Rational(Integer(3), Integer(2)) * parameters.separation;
}

}  // namespace

Rational reach_of_candidates(const PerturbationParameters& parameters) {
  const Rational reach = reach_in_place(parameters);
  if (parameters.candidates != CandidateRule::pruned) return reach;
  return reach + (Rational(1) + parameters.radius_variation) * parameters.perturbation;
}

template <int m>
CandidateTest<m>::CandidateTest(const Atlas<m>& atlas, const PointSet<m>& points, const PlacedLabels& placed,
                                const PerturbationParameters& parameters)
    : atlas_(atlas),
      points_(points),
      placed_(placed),
      parameters_(parameters),
      filter_(filter_metric(atlas)),
      exact_(atlas.metric().template on<Rational>()),
      view_(atlas, points) {}

template <int m>
void CandidateTest<m>::prepare(Label i) {
  const Rational& unit = atlas_.sampling_radius(i);
  const bool pruned = parameters_.candidates == CandidateRule::pruned;
  squared_tolerance_ = square(parameters_.tolerance * unit);
  filter_squared_tolerance_ = scalar_from<Filter>(squared_tolerance_);

  const Filter squared_reach = scalar_from<Filter>(square(reach_in_place(parameters_) * unit));
  atlas_.sightings(i, approximate_double(reach_of_candidates(parameters_) * unit) * (1 + 0x1p-40), seen_);
  view_.clear(i);
  const auto& filter_centre = atlas_.net().enclosure(i);
  for (const Sighting<m>& sighting : seen_) {
    if (label_of<m>(sighting) == i) continue;
    if (pruned && placed_[sighting.index] == 0) continue;
    const PointSet<m>& measured = pruned ? points_ : atlas_.net();
    const auto position = atlas_.carry(i, sighting, measured.enclosure(label_of<m>(sighting)));
    if (is_refuted(less(filter_.squared_norm(difference(position, filter_centre)), squared_reach))) continue;
    view_.add(sighting);
  }
  const Filter squared_edge_bound = scalar_from<Filter>(square(parameters_.edge_bound * unit));
  view_.connect(filter_, pruned ? &squared_edge_bound : nullptr);

  // What is not tested against may be wanted to choose by.
  const Rational reach_of_spheres =
      (parameters_.perturbation + maximum(parameters_.tolerance, parameters_.clearance)) * unit;
  Collector collector;
  collector.test = this;
  collector.least_vertices = parameters_.candidates == CandidateRule::printed ? m + 1 : 2;
  if (pruned) {
    collector.squared_radius_bound = square(parameters_.circumradius_bound * unit);
    collector.filter_squared_radius_bound = scalar_from<Filter>(*collector.squared_radius_bound);
    collector.far_power =
        scalar_from<Filter>(reach_of_spheres * (Rational(2) * parameters_.circumradius_bound * unit + reach_of_spheres))
            .upper();
  }
  collector.centre = atlas_.net().exact(i);
  collector.filter_centre = filter_centre;
  collector.squared_reach = square(reach_of_spheres);
  collector.filter_squared_reach = scalar_from<Filter>(collector.squared_reach);
  candidates_.clear();
  visited_ = 0;
  SimplexWalk<m, Collector> walk(view_, filter_, exact_, collector);
  for (std::uint32_t origin = 0; origin < view_.size(); ++origin) walk.from(origin);
  ladder_statistics().count(Rung::interval, visited_);
}

template <int m>
bool CandidateTest<m>::accepts(const Vector<Rational, m>& x) const {
  Vector<Filter, m> filter_x;
  for (std::size_t axis = 0; axis < m; ++axis) filter_x[axis] = scalar_from<Filter>(x[axis]);
  for (const Candidate<m>& candidate : candidates_) {
    if (!is_far(candidate, filter_x, x)) return false;
  }
  return true;
}

template <int m>
bool CandidateTest<m>::is_far(const Candidate<m>& candidate, const Vector<Filter, m>& filter_x,
                              const Vector<Rational, m>& x) const {
  if (candidate.in_filter) {
    const auto offset = difference(filter_x, view_.position(candidate.vertices[0]));
    const Filter power = filter_.squared_norm(offset) - Filter(2) * filter_.inner(offset, candidate.centre);
    const Verdict verdict = is_farther(power, candidate.squared_radius, filter_squared_tolerance_);
    if (!is_undecided(verdict)) {
      ladder_statistics().count(Rung::interval);
      return is_proved(verdict);
    }
  }
  return is_proved(decide_above_filter([&]<class S>() { return is_far_in<S>(candidate, x); }));
}

template <int m>
template <class S>
Verdict CandidateTest<m>::is_far_in(const Candidate<m>& candidate, const Vector<Rational, m>& x) const {
  const auto metric = atlas_.metric().template on<S>();
  SphereStack<S, m> stack(metric);
  const auto origin = view_.template position_in<S>(candidate.vertices[0]);
  for (std::uint32_t at = 1; at < candidate.vertex_count; ++at) {
    const auto edge = difference(view_.template position_in<S>(candidate.vertices[at]), origin);
    const Verdict non_degenerate = stack.push(edge, metric.squared_norm(edge));
    if (is_undecided(non_degenerate)) return Verdict::undecided;
  }
  Vector<S, m> offset;
  for (std::size_t axis = 0; axis < m; ++axis) offset[axis] = scalar_from<S>(x[axis]) - origin[axis];
  return is_farther(stack.power(offset, metric.squared_norm(offset)), stack.squared_radius(),
                    scalar_from<S>(squared_tolerance_));
}

#define DELCERT_INSTANTIATE(m) template class CandidateTest<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
