#include "kernel/perturb/forbidden_search.hpp"

#include "kernel/chart/length_units.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/perturb/candidates.hpp"
#include "kernel/perturb/rounded_walk.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

template <int m>
class Search {
 public:
  static constexpr bool visits_top = true;

  /// References are kept. Precondition: a `FilterGuard` is alive.
  Search(const Atlas<m>& atlas, const PointSet<m>& points, const LengthUnits& units,
         const ForbiddenPropertiesParameters<Rational>& parameters, const Rational& perturbation)
      : atlas_(atlas),
        points_(points),
        parameters_(parameters),
        units_(units),
        shift_(approximate_double(Rational(2) * perturbation)),
        edge_bound_(approximate_double(parameters.edge_bound)),
        exact_(atlas.metric().template on<Rational>()),
        view_(atlas, points),
        filter_(atlas.metric().template on<Filter>()),
        greatest_squared_edge_bound_(scalar_from<Filter>(square(parameters.edge_bound))),
        greatest_squared_radius_bound_(scalar_from<Filter>(Rational(4) * square(parameters.sampling_radius))),
        squared_hoop_(scalar_from<Filter>(parameters.squared_hoop_bound)),
        frame_(filter_, atlas.metric().gram()) {}

  /// The sets whose smallest label is i.
  void look_at(Label i) {
    const FilterGuard guard;
    // No label of a set counts for more than this one.
    const double unit = units_.of(i);
    const Filter squared_unit = square(Filter::exactly(unit));
    squared_edge_bound_ = greatest_squared_edge_bound_ * squared_unit;
    squared_radius_bound_ = greatest_squared_radius_bound_ * squared_unit;
    atlas_.sightings(i, (edge_bound_ * unit + shift_) * (1 + 0x1p-40), seen_);
    view_.clear(i);
    // i itself first, at home; then the larger labels that are near enough to it.
    for (const Sighting<m>& sighting : seen_) {
      if (label_of<m>(sighting) == i && sighting.is_unmoved()) view_.add(sighting);
    }
    for (const Sighting<m>& sighting : seen_) {
      if (!(i < label_of<m>(sighting))) continue;
      const auto position = atlas_.carry(i, sighting, points_.enclosure(label_of<m>(sighting)));
      const auto distance = filter_.squared_norm(difference(position, view_.position(0)));
      if (!is_refuted(less(distance, squared_edge_bound_))) view_.add(sighting);
    }
    SimplexWalk<m, Search> walk(view_, filter_, exact_, *this);
    if constexpr (m <= 3) {
      frame_.measure_by(edge_bound_ * unit);
      frame_.look_about(view_.position(0));
      places_.fill(frame_, view_);
      if (places_.error <= RoundedPlaces<m>::most_error) {
        const Filter scale = Filter::exactly(frame_.scale());
        const Filter squared_edge = squared_edge_bound_ * square(scale);
        view_.connect(filter_, squared_edge_bound_, places_.is_below(squared_edge));
        if (!bounds_ || bounded_unit_ != unit || bounded_size_ != places_.size || bounded_error_ != places_.error) {
          bounded_unit_ = unit;
          bounded_size_ = places_.size;
          bounded_error_ = places_.error;
          bounds_.emplace(places_.size, places_.error, squared_edge.upper() * (1 + 0x1p-8));
          take_bounds(*bounds_, square_root(squared_radius_bound_) * scale);
        }
        RoundedWalk<m, Search>(view_, places_.at, *bounds_, walk, *this).from(0);
        return;
      }
    }
    view_.connect(filter_, &squared_edge_bound_);
    walk.from(0);
  }

  ForbiddenSearch result;

  // The visitor's part.

  template <class S>
  void start(const Vector<S, m>&) {}

  /// Prunes on P2: a facet that contains this simplex has no smaller circumradius. Else, from dimension 2 on, the
  /// simplex itself is looked at: P1 asks that its last vertex be within α₀R of the opposite circumsphere, hence of
  /// the hull of that facet, and R of the facet is at most that of the simplex.
  template <class S>
  bool enter(const SphereStack<S, m>& stack, std::span<const std::uint32_t> vertices) {
    ++result.simplices;
    if constexpr (std::same_as<S, Filter>) {
      if (vertices.size() >= 3) {
        ++result.configurations;
        const Filter most = squared_hoop_ * minimum(stack.squared_radius(), squared_radius_bound_);
        if (!is_proved(less(most, stack.squared_altitude()))) decide_exactly(vertices);
      }
      return !is_refuted(less(stack.squared_radius(), squared_radius_bound_));
    } else {
      if (vertices.size() >= 3) {
        ++result.configurations;
        decide_exactly(vertices);
      }
      return stack.squared_radius() < Rational(4) * square(parameters_.sampling_radius * unit_of(vertices.first(1)));
    }
  }

  /// A degenerate simplex may be a forbidden configuration, but is no face of a facet of one.
  void degenerate(std::span<const std::uint32_t> vertices) {
    if (vertices.size() < 3) return;
    ++result.configurations;
    decide_exactly(vertices);
  }

  /// m + 2 points: P1 asks that the last be within α₀R of the sphere of the others.
  template <class S>
  void top(const SphereStack<S, m>& stack, std::span<const std::uint32_t> vertices, std::uint32_t apex,
           const Vector<S, m>& edge, const S& squared_edge) {
    ++result.configurations;
    if constexpr (std::same_as<S, Filter>) {
      const Filter power = stack.power(edge, squared_edge);
      if (is_proved(is_farther(power, stack.squared_radius(), squared_hoop_ * stack.squared_radius()))) return;
    }
    std::array<std::uint32_t, static_cast<std::size_t>(m) + 2> all{};
    std::copy(vertices.begin(), vertices.end(), all.begin());
    all[vertices.size()] = apex;
    decide_exactly({all.data(), vertices.size() + 1});
  }

  // The same in doubles. What is looked at is far from a hoop for every radius below the bound: nearly always.

  void start_rounded(const Vector<double, m>&) {}

  RoundedAnswer enter_rounded(const FaceForm<double, m>& face, std::span<const std::uint32_t> vertices) {
    // The weight is the squared altitude times the base.
    if (vertices.size() >= 3 && !(face.sphere.weight - squared_hoop_reach_ * face.base > altitude_error_))
      return RoundedAnswer::unsure;
    const RoundedAnswer answer = sized(face.sphere.norm, face.sphere.weight, vertices.size());
    if (answer != RoundedAnswer::unsure) count(1, vertices.size());
    return answer;
  }

  void facet_rounded(const FacetForm<double, m>& facet) { least_slope_ = hoop_reach_ * facet.covector_norm; }

  RoundedAnswer over_rounded(const FacetForm<double, m>& facet, const ApexForm<double>& apex,
                             std::span<const std::uint32_t> vertices) {
    if (vertices.size() >= 3 && !(std::fabs(apex.slope) - least_slope_ > slope_error_)) return RoundedAnswer::unsure;
    return sized(apex.norm(facet), apex.weight, vertices.size());
  }
  void count_over(std::uint64_t number) { count(number, m + 1); }

  bool top_rounded(const SphereForm<double, m>& form, const Vector<double, m>& edge, double squared_edge) {
    const SphereGap<double> gap(form.power(edge, squared_edge), form.norm, form.weight, hoop_reach_);
    if (!is_proved(is_farther(gap, *gap_bound_))) return false;
    ++result.configurations;
    return true;
  }

 private:
  void count(std::uint64_t number, std::size_t vertex_count) {
    result.simplices += number;
    if (vertex_count >= 3) result.configurations += number;
  }

  /// Prunes on P2.
  [[nodiscard]] RoundedAnswer sized(double norm, double weight, std::size_t vertex_count) const {
    const double excess = norm - doubled_radius_bound_ * weight;
    const double error = radius_errors_[vertex_count];
    if (!(std::fabs(excess) > error)) return RoundedAnswer::unsure;
    return excess > 0 ? RoundedAnswer::stop : RoundedAnswer::go_on;
  }

  /// What the doubles compare with, and how wrong the comparisons are; `radius` is the bound of P2 in the frame.
  void take_bounds(const RoundedBounds<m>& bounds, const Filter& radius) {
    const auto take = [](const Filter& length, double& value) {
      value = length.upper();
      return RoundingBound::of(value, (Filter::exactly(value) - Filter::exactly(length.lower())).upper());
    };
    const Filter hoop = square_root(squared_hoop_) * radius;
    const RoundingBound hoop_reach = take(hoop, hoop_reach_);
    const RoundingBound squared_hoop_reach = take(square(hoop), squared_hoop_reach_);
    const RoundingBound doubled_radius = take(twice(radius), doubled_radius_bound_);
    for (std::size_t k = 1; k < m; ++k) {
      const auto& form = bounds.face[k].sphere;
      radius_errors_[k + 1] = (form.norm - doubled_radius * form.weight).error();
      altitude_error_ = (form.weight - squared_hoop_reach * bounds.face[k].base).error();
    }
    const auto facet = bounds.facet();
    const auto apex = bounds.apex();
    radius_errors_[m + 1] = (apex.norm(facet) - doubled_radius * apex.weight).error();
    slope_error_ = (apex.slope - hoop_reach * facet.covector_norm).error();
    const auto form = apex.form(facet);
    gap_bound_.emplace(form.power(bounds.edge, bounds.squared_edge), form.norm, form.weight, hoop_reach);
  }

  /// The least of the labels.
  [[nodiscard]] Rational unit_of(std::span<const std::uint32_t> vertices) const {
    double least = 1;
    for (const std::uint32_t vertex : vertices) least = std::min(least, units_.of(view_.label(vertex)));
    return Rational::exactly(least);
  }

  void decide_exactly(std::span<const std::uint32_t> vertices) {
    ++result.decided_exactly;
    std::vector<std::vector<Rational>> coordinates;
    for (const std::uint32_t vertex : vertices) {
      const auto position = view_.template position_in<Rational>(vertex);
      coordinates.emplace_back(position.begin(), position.end());
    }
    const auto inner = [this](const std::vector<Rational>& x, const std::vector<Rational>& y) {
      Vector<Rational, m> a;
      Vector<Rational, m> b;
      std::copy(x.begin(), x.end(), a.begin());
      std::copy(y.begin(), y.end(), b.begin());
      return exact_.inner(a, b);
    };
    ForbiddenPropertiesParameters<Rational> parameters = parameters_;
    parameters.sampling_radius *= unit_of(vertices);
    parameters.edge_bound *= unit_of(vertices);
    const Verdict verdict = has_forbidden_properties(edge_gram_from_points(coordinates, inner), parameters);
    ladder_statistics().count(Rung::rational);
    if (is_refuted(verdict) || result.found) return;
    result.found.emplace();
    for (const std::uint32_t vertex : vertices) result.found->push_back(view_.label(vertex));
  }

  const Atlas<m>& atlas_;
  const PointSet<m>& points_;
  ForbiddenPropertiesParameters<Rational> parameters_;
  const LengthUnits& units_;
  double shift_;
  double edge_bound_;
  MetricOn<Rational, m> exact_;
  PatchView<m> view_;
  MetricOn<Filter, m> filter_;
  Filter greatest_squared_edge_bound_;
  Filter greatest_squared_radius_bound_;
  Filter squared_edge_bound_;  // of the label at hand
  Filter squared_radius_bound_;
  Filter squared_hoop_;
  std::vector<Sighting<m>> seen_;

  RoundedFrame<m> frame_;
  RoundedPlaces<m> places_;
  std::optional<RoundedBounds<m>> bounds_;
  double bounded_unit_ = 0;  // for which the bounds were computed
  double bounded_size_ = 0;
  double bounded_error_ = 0;
  // In the frame; α₀R is at most the first.
  double hoop_reach_ = 0;
  double squared_hoop_reach_ = 0;
  double doubled_radius_bound_ = 0;
  double least_slope_ = 0;                                               // of the facet at hand
  std::array<double, static_cast<std::size_t>(m) + 2> radius_errors_{};  // by vertex count
  double altitude_error_ = 0;
  double slope_error_ = 0;
  std::optional<SphereGap<RoundingBound>> gap_bound_;
};

}  // namespace

template <int m>
ForbiddenSearch search_forbidden(const Atlas<m>& atlas, const PointSet<m>& points,
                                 const ForbiddenPropertiesParameters<Rational>& parameters,
                                 const Rational& perturbation, const Progress& progress) {
  ForbiddenSearch result;
  const LengthUnits units(atlas);
  const auto look = [&](std::size_t first, std::size_t last) {
    auto search = [&] {
      const FilterGuard guard;
      return Search<m>(atlas, points, units, parameters, perturbation);
    }();
    for (std::size_t index = first; index < last && !search.result.found; ++index) search.look_at(Label(index));
    ladder_statistics().count(Rung::interval, search.result.configurations - search.result.decided_exactly);
    return search.result;
  };
  in_parts("search forbidden configurations", atlas.size(), progress, look, [&result](const ForbiddenSearch& here) {
    if (result.found) return;
    result.simplices += here.simplices;
    result.configurations += here.configurations;
    result.decided_exactly += here.decided_exactly;
    result.found = here.found;
  });
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                  \
  template ForbiddenSearch search_forbidden<m>(const Atlas<m>&, const PointSet<m>&,                             \
                                               const ForbiddenPropertiesParameters<Rational>&, const Rational&, \
                                               const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
