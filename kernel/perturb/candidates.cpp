#include "kernel/perturb/candidates.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// Bounds of the forms of simplices by their numbers of vertices, with those of the power of the original point, which
/// the origin is up to this error.
template <int m, class Note>
void for_each_bounded_form(const RoundedBounds<m>& bounds, double error, const Note& note) {
  Vector<RoundingBound, m> origin;
  origin.fill(RoundingBound::of(error, error));
  const auto offset = difference(origin, bounds.place);
  const RoundingBound squared = pairing(offset, offset);
  for (std::size_t k = 1; k < m; ++k) note(k + 1, bounds.face[k].sphere, bounds.face[k].sphere.power(offset, squared));
  const auto facet = bounds.facet();
  const auto apex = bounds.apex();
  note(m + 1, apex.form(facet), apex.signed_power(ApexForm<RoundingBound>::probe(facet, offset, squared)));
}

}  // namespace

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

  // In the frame, whose origin is nearly the original point.
  double reach = 0;
  double circumradius_bound = 0;
  std::array<double, static_cast<std::size_t>(m) + 2> certain_gap_errors{};  // by vertex count
  Vector<double, m> offset{};
  double squared_offset = 0;
  ApexForm<double>::Probe rounded_probe{};

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
    take_sphere(stack.centre(), stack.squared_radius());
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
    take_sphere(stack.centre_over(apex), apex.squared_radius);
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

  void start_rounded(const Vector<double, m>& place) {
    for (std::size_t axis = 0; axis < m; ++axis) offset[axis] = -place[axis];
    squared_offset = pairing(offset, offset);
  }

  /// Whether the circumradius 2wR/2w is below its bound; `bound` is that of both.
  [[nodiscard]] Verdict is_small(double norm, double weight, std::size_t vertex_count) const {
    const double excess = norm - (circumradius_bound + circumradius_bound) * weight;
    if (excess > test->radius_errors_[vertex_count]) return Verdict::refuted;
    return excess < -test->radius_errors_[vertex_count] ? Verdict::proved : Verdict::undecided;
  }

  /// As `bound_gaps` does, for what follows.
  void bound_certain_gaps() {
    for_each_bounded_form<m>(
        *test->bounds_, test->bounded_error_,
        [this](std::size_t vertex_count, const SphereForm<RoundingBound, m>& form, const RoundingBound& power) {
          const auto& lengths = test->lengths_;
          certain_gap_errors[vertex_count] =
              certain_gap(power, form.weight, lengths.bound_of_reach_of_spheres, lengths.bound_of_circumradius_bound)
                  .error();
        });
  }
  /// Whether the sphere is out of reach whatever its radius below the bound.
  [[nodiscard]] bool is_certainly_far(double power, double weight, std::size_t vertex_count) const {
    return certain_gap(power, weight, reach, circumradius_bound) > certain_gap_errors[vertex_count];
  }

  RoundedAnswer enter_rounded(const FaceForm<double, m>& face, std::span<const std::uint32_t> vertices) {
    const SphereForm<double, m>& form = face.sphere;
    const Verdict small = is_small(form.norm, form.weight, vertices.size());
    if (is_undecided(small)) return RoundedAnswer::unsure;
    if (is_proved(small) && vertices.size() >= least_vertices) {
      const double power = form.power(offset, squared_offset);
      if (!is_certainly_far(power, form.weight, vertices.size())) {
        const SphereGap<double> gap(power, form.norm, form.weight, reach);
        const Verdict farther = is_farther(gap, *test->centre_gap_bounds_[vertices.size()]);
        if (is_undecided(farther)) return RoundedAnswer::unsure;
        if (is_refuted(farther)) add(vertices, form);
      }
    }
    ++test->visited_;
    return is_proved(small) ? RoundedAnswer::go_on : RoundedAnswer::stop;
  }

  void facet_rounded(const FacetForm<double, m>& facet) {
    rounded_probe = ApexForm<double>::probe(facet, offset, squared_offset);
  }

  RoundedAnswer over_rounded(const FacetForm<double, m>& facet, const ApexForm<double>& apex,
                             std::span<const std::uint32_t> vertices) {
    const double power = apex.signed_power(rounded_probe);
    if (is_certainly_far(power, apex.weight, m + 1)) return RoundedAnswer::stop;
    const double norm = apex.norm(facet);
    const Verdict small = is_small(norm, apex.weight, m + 1);
    if (is_undecided(small)) return RoundedAnswer::unsure;
    if (is_proved(small)) {
      const SphereGap<double> gap(apex.slope < 0 ? -power : power, norm, apex.weight, reach);
      const Verdict farther = is_farther(gap, *test->centre_gap_bounds_[m + 1]);
      if (is_undecided(farther)) return RoundedAnswer::unsure;
      if (is_refuted(farther)) add(vertices, apex.form(facet));
    }
    return RoundedAnswer::stop;
  }
  void count_over(std::uint64_t count) { test->visited_ += count; }

  void add(std::span<const std::uint32_t> vertices, const SphereForm<double, m>& form) {
    add(vertices);
    test->candidates_.back().sphere = form;
    test->candidates_.back().is_bounded = true;
  }

  void take_sphere(const Vector<Filter, m>& about, const Filter& squared_radius) {
    SphereForm<double, m>& sphere = test->candidates_.back().sphere;
    sphere.weight = 1;
    sphere.norm = 2 * test->frame_.scale() * square_root(squared_radius).lower();
    const auto place = test->frame_.vector(about);
    for (std::size_t axis = 0; axis < m; ++axis) sphere.normal[axis] = 2 * place.at[axis];
  }

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
      view_(atlas, points),
      frame_([&] {
        const FilterGuard guard;
        return RoundedFrame<m>(filter_, atlas.metric().gram());
      }()) {}

namespace {

/// A length that doubles compute with: rounded, and how much it is rounded by at most.
double rounded(const Rational& length, RoundingBound& bound) {
  const Filter enclosure = scalar_from<Filter>(length);
  const Filter width = Filter::exactly(enclosure.upper()) - Filter::exactly(enclosure.lower());
  bound = RoundingBound::of(enclosure.upper(), width.upper());
  return enclosure.upper();
}

}  // namespace

template <int m>
void CandidateTest<m>::measure_in(const Rational& unit) {
  Lengths& lengths = lengths_;
  lengths.unit = unit;
  // What is not tested against may be wanted to choose by.
  lengths.reach_of_spheres = (parameters_.perturbation + maximum(parameters_.tolerance, parameters_.clearance)) * unit;
  const Rational reach = reach_of_candidates(parameters_);
  const auto slightly_more = [&unit](const Rational& factor) {
    return approximate_double(factor * unit) * (1 + 0x1p-40);
  };
  lengths.reach_of_sightings = slightly_more(reach);
  lengths.reach_around = slightly_more(reach_around_ ? maximum(reach, *reach_around_) : reach);
  lengths.squared_reach = scalar_from<Filter>(square(reach_in_place(parameters_) * unit));
  lengths.squared_edge_bound = scalar_from<Filter>(square(parameters_.edge_bound * unit));
  lengths.squared_reach_of_spheres = square(lengths.reach_of_spheres);
  lengths.filter_squared_reach_of_spheres = scalar_from<Filter>(lengths.squared_reach_of_spheres);
  lengths.squared_circumradius_bound = square(parameters_.circumradius_bound * unit);
  lengths.filter_squared_circumradius_bound = scalar_from<Filter>(lengths.squared_circumradius_bound);
  lengths.far_power =
      scalar_from<Filter>(lengths.reach_of_spheres *
                          (Rational(2) * parameters_.circumradius_bound * unit + lengths.reach_of_spheres))
          .upper();
  lengths.squared_tolerance = square(parameters_.tolerance * unit);
  lengths.filter_squared_tolerance = scalar_from<Filter>(lengths.squared_tolerance);

  frame_.measure_by(scalar_from<Filter>(parameters_.edge_bound * unit).upper());
  const Rational scale = Rational::exactly(frame_.scale());
  lengths.scaled_reach_of_spheres = rounded(lengths.reach_of_spheres * scale, lengths.bound_of_reach_of_spheres);
  lengths.scaled_circumradius_bound =
      rounded(parameters_.circumradius_bound * unit * scale, lengths.bound_of_circumradius_bound);
  lengths.scaled_tolerance = rounded(parameters_.tolerance * unit * scale, lengths.bound_of_tolerance);
  bounds_.reset();
  lengths.largest_offset = scalar_from<Filter>(parameters_.perturbation * unit * scale).upper() * (1 + 0x1p-10);
}

template <int m>
void CandidateTest<m>::look_in_doubles() {
  in_doubles_ = false;
  places_.fill(frame_, view_);
  if constexpr (m <= 3) {
    const double origin_error = frame_.place(atlas_.net().enclosure(view_.chart())).error;
    if (!is_pruned() || !uses_doubles_ || !(places_.error <= RoundedPlaces<m>::most_error)) return;
    if (!(origin_error <= RoundedPlaces<m>::most_error)) return;
    places_.error = std::fmax(places_.error, origin_error);
    in_doubles_ = true;
    if (bounds_ && bounded_size_ == places_.size && bounded_error_ == places_.error) return;
    bounded_size_ = places_.size;
    bounded_error_ = places_.error;
    error_of_x_ = 4 * places_.error + 0x1p-50;
    // Edges are below their bound or not certainly above it.
    const double scale = frame_.scale();
    bounds_.emplace(places_.size, places_.error, lengths_.squared_edge_bound.upper() * scale * scale * (1 + 0x1p-8));
    bound_gaps();
  }
}

/// Marks as adjacent all pairs but those certainly at least the edge bound apart.
template <int m>
void CandidateTest<m>::connect() {
  if (!is_pruned()) {
    view_.connect(filter_, nullptr);
  } else if (!in_doubles_) {
    view_.connect(filter_, &lengths_.squared_edge_bound);
  } else {
    const Filter scale = Filter::exactly(frame_.scale());
    view_.connect(filter_, lengths_.squared_edge_bound, places_.is_below(lengths_.squared_edge_bound * square(scale)));
  }
}

template <int m>
void CandidateTest<m>::look(Label i) {
  atlas_.sightings(i, lengths_.reach_around, seen_);
  // Where transitions are not isometries, the chart may show a point as near that is too far away to be tested against:
  // another sheet of a submanifold, for example.
  if (reach_around_) atlas_.sightings(i, lengths_.reach_of_sightings, seen_near_);
  // Both are sorted: of what is near, the first that does not come before a sighting.
  auto near = seen_near_.cbegin();
  const auto is_near = [&](const Sighting<m>& sighting) {
    if (!reach_around_) return true;
    while (near != seen_near_.cend() && *near < sighting) ++near;
    return near != seen_near_.cend() && *near == sighting;
  };
  view_.clear(i);
  around_.clear();
  const auto& centre = atlas_.net().enclosure(i);
  frame_.look_about(centre);
  for (const Sighting<m>& sighting : seen_) {
    const Label label = label_of<m>(sighting);
    if (label == i) continue;
    const bool is_placed = placed_[label.value] != 0;
    // In the reference modes simplices are on labels: their original points tell which.
    const bool is_wanted = is_placed || !is_pruned();
    if (!is_wanted && !reach_around_) continue;
    const auto position = atlas_.carry(i, sighting, (is_placed ? points_ : atlas_.net()).enclosure(label));
    if (reach_around_) around_.push_back({frame_.at(position), is_placed});
    if (!is_wanted || !is_near(sighting)) continue;
    const auto& measured = is_pruned() ? position : atlas_.carry(i, sighting, atlas_.net().enclosure(label));
    if (is_refuted(less(filter_.squared_norm(difference(measured, centre)), lengths_.squared_reach))) continue;
    view_.add(sighting, position);
  }
}

template <int m>
void CandidateTest<m>::prepare(Label i) {
  const Rational& unit = atlas_.sampling_radius(i);
  if (lengths_.unit != unit) measure_in(unit);
  look(i);
  look_in_doubles();
  connect();

  Collector collector;
  collector.test = this;
  collector.least_vertices = parameters_.candidates == CandidateRule::printed ? m + 1 : 2;
  if (is_pruned()) {
    collector.squared_radius_bound = lengths_.squared_circumradius_bound;
    collector.filter_squared_radius_bound = lengths_.filter_squared_circumradius_bound;
    collector.far_power = lengths_.far_power;
  }
  collector.centre = atlas_.net().exact(i);
  collector.filter_centre = atlas_.net().enclosure(i);
  collector.squared_reach = lengths_.squared_reach_of_spheres;
  collector.filter_squared_reach = lengths_.filter_squared_reach_of_spheres;
  candidates_.clear();
  visited_ = 0;
  SimplexWalk<m, Collector> walk(view_, filter_, exact_, collector);
  bool is_done = false;
  if constexpr (m <= 3) {
    if (in_doubles_) {
      collector.reach = lengths_.scaled_reach_of_spheres;
      collector.circumradius_bound = lengths_.scaled_circumradius_bound;
      collector.bound_certain_gaps();
      RoundedWalk<m, Collector> in_doubles(view_, places_.at, *bounds_, walk, collector);
      for (std::uint32_t origin = 0; origin < view_.size(); ++origin) in_doubles.from(origin);
      is_done = true;
    }
  }
  if (!is_done) {
    for (std::uint32_t origin = 0; origin < view_.size(); ++origin) walk.from(origin);
  }
  ladder_statistics().count(Rung::interval, visited_);
}

/// Bounds of what the collector computes at the original point, and of what `is_far_in_doubles` does at perturbations.
template <int m>
void CandidateTest<m>::bound_gaps() {
  const RoundingBound doubled_radius = lengths_.bound_of_circumradius_bound + lengths_.bound_of_circumradius_bound;
  Vector<RoundingBound, m> anywhere;
  anywhere.fill(RoundingBound::of(lengths_.largest_offset + error_of_x_, error_of_x_));
  const auto from_anywhere = difference(anywhere, bounds_->place);
  for_each_bounded_form<m>(
      *bounds_, bounded_error_,
      [&](std::size_t vertex_count, const SphereForm<RoundingBound, m>& form, const RoundingBound& power) {
        radius_errors_[vertex_count] = (form.norm - doubled_radius * form.weight).error();
        centre_gap_bounds_[vertex_count].emplace(power, form.norm, form.weight, lengths_.bound_of_reach_of_spheres);
        gap_bounds_[vertex_count].emplace(form.power(from_anywhere, pairing(from_anywhere, from_anywhere)), form.norm,
                                          form.weight, lengths_.bound_of_tolerance);
      });
}

template <int m>
bool CandidateTest<m>::accepts(const Vector<Rational, m>& x) const {
  Vector<Filter, m> enclosure;
  for (std::size_t axis = 0; axis < m; ++axis) enclosure[axis] = scalar_from<Filter>(x[axis]);
  return accepts(enclosure, [&x] { return x; });
}

template <int m>
bool CandidateTest<m>::accepts(const Vector<Filter, m>& enclosure,
                               const std::function<Vector<Rational, m>()>& exactly) const {
  const auto place = frame_.place(enclosure);
  bool is_bounded = in_doubles_ && place.error <= error_of_x_;
  for (const double coordinate : place.at) is_bounded = is_bounded && std::fabs(coordinate) <= lengths_.largest_offset;
  std::optional<Vector<Rational, m>> x;
  for (const Candidate<m>& candidate : candidates_) {
    if (is_bounded && candidate.is_bounded) {
      const Verdict verdict = is_far_in_doubles(candidate, place.at);
      if (is_proved(verdict)) {
        ladder_statistics().count(Rung::interval);
        continue;
      }
      if (is_refuted(verdict)) {
        ladder_statistics().count(Rung::interval);
        return false;
      }
    }
    const Verdict verdict = is_far_in_filter(candidate, enclosure);
    if (!is_undecided(verdict)) {
      ladder_statistics().count(Rung::interval);
      if (is_refuted(verdict)) return false;
      continue;
    }
    if (!x) x = exactly();
    if (!is_proved(decide_above_filter([&]<class S>() { return is_far_in<S>(candidate, *x); }))) return false;
  }
  return true;
}

template <int m>
Verdict CandidateTest<m>::is_far_in_doubles(const Candidate<m>& candidate, const Vector<double, m>& x) const {
  const auto offset = difference(x, places_.at[candidate.vertices[0]]);
  const SphereForm<double, m>& form = candidate.sphere;
  const SphereGap<double> gap(form.power(offset, pairing(offset, offset)), form.norm, form.weight,
                              lengths_.scaled_tolerance);
  return is_farther(gap, *gap_bounds_[candidate.vertex_count]);
}

template <int m>
Verdict CandidateTest<m>::is_far_in_filter(const Candidate<m>& candidate, const Vector<Filter, m>& x) const {
  SphereStack<Filter, m> stack(filter_);
  const auto& origin = view_.position(candidate.vertices[0]);
  for (std::uint32_t at = 1; at < candidate.vertex_count; ++at) {
    const auto edge = difference(view_.position(candidate.vertices[at]), origin);
    if (!is_proved(stack.push(edge, filter_.squared_norm(edge)))) return Verdict::undecided;
  }
  const auto offset = difference(x, origin);
  return is_farther(stack.power(offset, filter_.squared_norm(offset)), stack.squared_radius(),
                    lengths_.filter_squared_tolerance);
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
                    scalar_from<S>(lengths_.squared_tolerance));
}

#define DELCERT_INSTANTIATE(m) template class CandidateTest<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
