#include "kernel/stars/protection.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "kernel/chart/length_units.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/ladder.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "kernel/simplex/sphere_stack.hpp"
#include "kernel/stars/approximate_sphere.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr long margin_digits = 12;
constexpr long margins_per_octave = 1L << (margin_digits - 1);

/// The positive numbers of 12 binary digits in increasing order, from 1 at 0.
Rational margin_number(long index) {
  const long octave =
      index >= 0 ? index / margins_per_octave : -((margins_per_octave - 1 - index) / margins_per_octave);
  return Rational(margins_per_octave + index - octave * margins_per_octave) *
         Rational::power_of_two(octave - margin_digits + 1);
}

/// The index of the largest of them that is not above x > 0.
long index_below(const Rational& x) {
  const long octave = binary_exponent(x);
  const Integer digits = floor_of(x * Rational::power_of_two(margin_digits - 1 - octave));
  return octave * margins_per_octave + digits.convert_to<long>() - margins_per_octave;
}

template <class S, int m>
using Corners = std::array<Vector<S, m>, corners<m>>;

/// |q − C| > R + δ, given the power P of q: P − δ² > 0 and (P − δ²)² > 4δ²R².
template <class S>
Verdict is_outside_by(const S& power, const S& squared_radius, const S& protection) {
  const S shifted = power - square(protection);
  return conjunction(less(S(0), shifted), less(S(4) * square(protection) * squared_radius, square(shifted)));
}

/// Cells of this many sampling radii: queries ask for up to 2.
constexpr double cell_factor = 1.5;

/// The bounds over all simplices as they are found.
struct Extremes {
  double least = std::numeric_limits<double>::infinity();
  double least_upper = std::numeric_limits<double>::infinity();

  void include(double lower, double upper) {
    least = std::min(least, lower);
    least_upper = std::min(least_upper, upper);
  }
};

/// What measuring goes by, the same for all simplices.
template <int m>
struct Ground {
  Ground(const FlatAtlas<m>& of_points, const PointSet<m>& placed, const StarComplex<m>& of_simplices)
      : atlas(of_points),
        points(placed),
        complex(of_simplices),
        filter([&] {
          const FilterGuard guard;
          return of_points.metric().template on<Filter>();
        }()),
        plain(of_points.metric().template on<PlainDouble>()),
        units(of_points),
        half_radius(approximate_double(of_points.sampling_radius()) / 2),
        grid(of_points.metric(), of_points.space().box_radius(),
             cell_factor * approximate_double(of_points.sampling_radius()) * middle_unit(of_points.radii().units()),
             placed.size()) {
    for (const auto& point : placed.approximate_all()) grid.insert(point);
  }

  const FlatAtlas<m>& atlas;
  const PointSet<m>& points;
  const StarComplex<m>& complex;
  MetricOn<Filter, m> filter;
  MetricOn<PlainDouble, m> plain;
  LengthUnits units;
  double half_radius;
  PointGrid<m> grid;
};

/// Of simplices that follow each other.
struct MeasuredPart {
  std::vector<double> lower;  // bounds of their protections
  Extremes protection;
  Extremes thickness;
  Extremes negated_radius;
  std::vector<StarFailure> failures;
};

template <int m>
class Measurement {
 public:
  /// A reference is kept.
  explicit Measurement(const Ground<m>& ground)
      : atlas_(ground.atlas),
        points_(ground.points),
        complex_(ground.complex),
        filter_(ground.filter),
        plain_(ground.plain),
        units_(ground.units),
        half_radius_(ground.half_radius),
        grid_(ground.grid) {}

  [[nodiscard]] MeasuredPart part(std::size_t first, std::size_t last, const std::optional<Rational>& required) {
    std::vector<double> lower;
    for (std::size_t at = first; at < last; ++at) {
      take_unit(complex_.simplices()[at]);
      measure(at, required);
      lower.push_back(least_margin_);
    }
    return {std::move(lower), protection_, thickness_, negated_radius_, std::move(report_.failures)};
  }

  void include(MeasuredPart part) {
    lower_.insert(lower_.end(), part.lower.begin(), part.lower.end());
    protection_.include(part.protection.least, part.protection.least_upper);
    thickness_.include(part.thickness.least, part.thickness.least_upper);
    negated_radius_.include(part.negated_radius.least, part.negated_radius.least_upper);
    std::move(part.failures.begin(), part.failures.end(), std::back_inserter(report_.failures));
  }

  /// When all parts have been included, in order.
  [[nodiscard]] ProtectionReport report() {
    if (report_.failures.empty() && !complex_.simplices().empty()) report_.margins = margins();
    return std::move(report_);
  }

 private:
  template <class S>
  Corners<S, m> positions(const LiftedSimplex<m>& simplex) const {
    Corners<S, m> result;
    for (std::size_t corner = 0; corner < corners<m>; ++corner) result[corner] = position<S>(simplex[corner]);
    return result;
  }
  template <class S>
  Vector<S, m> position(const Lift<m>& lift) const {
    const Label label(lift.index);
    const auto carried = atlas_.carry(label, lift, points_.template coordinates<S>(label));
    if constexpr (std::same_as<S, Rational>) {
      return carried.value();
    } else {
      return carried;
    }
  }

  /// Pushes the vertices in the given order of corners; proved if the simplex is certainly non-degenerate.
  template <class S>
  static Verdict build(SphereStack<S, m>& stack, const MetricOn<S, m>& metric, const Corners<S, m>& vertices,
                       std::size_t last) {
    const std::size_t first = last == 0 ? 1 : 0;
    for (std::size_t corner = 0; corner < corners<m>; ++corner) {
      if (corner == first || corner == last) continue;
      const auto edge = difference(vertices[corner], vertices[first]);
      if (const Verdict ok = stack.push(edge, metric.squared_norm(edge)); !is_proved(ok)) return ok;
    }
    const auto edge = difference(vertices[last], vertices[first]);
    return stack.push(edge, metric.squared_norm(edge));
  }

  /// The verdict of `test` on the stack of a simplex and the power of a lift with respect to its sphere.
  template <class Test>
  Verdict decide_power(const LiftedSimplex<m>& simplex, const Lift<m>& lift, const Test& test) const {
    return decide([&]<class S>() {
      const auto metric = atlas_.metric().template on<S>();
      const auto vertices = positions<S>(simplex);
      SphereStack<S, m> stack(metric);
      if (const Verdict ok = build<S>(stack, metric, vertices, m); !is_proved(ok)) return ok;
      const auto offset = difference(position<S>(lift), vertices[0]);
      return test.template operator()<S>(stack.power(offset, metric.squared_norm(offset)), stack.squared_radius());
    });
  }

  /// The simplex is measured in the least unit of its vertices.
  void take_unit(const LiftedSimplex<m>& simplex) {
    least_ = Label(simplex[0].index);
    for (const Lift<m>& vertex : simplex) {
      if (units_.of(Label(vertex.index)) < units_.of(least_)) least_ = Label(vertex.index);
    }
    look_beyond_ = half_radius_ * units_.of(least_);
  }
  /// So much of a length that is claimed counts for the simplex.
  [[nodiscard]] Rational scaled(const Rational& length) const {
    return units_.vary() ? length * Rational::exactly(units_.of(least_)) : length;
  }

  /// Fills near_ with all lifts within the circumradius and twice `look_beyond_` of the approximate centre.
  ApproximateSphere<m> look_around(const LiftedSimplex<m>& simplex) {
    Corners<double, m> approximate;
    for (std::size_t corner = 0; corner < corners<m>; ++corner) {
      approximate[corner] = points_.approximate(Label(simplex[corner].index));
      for (std::size_t axis = 0; axis < m; ++axis) approximate[corner][axis] += simplex[corner].shift[axis];
    }
    const auto sphere = approximate_sphere<m>(plain_, approximate);
    near_.clear();
    if (std::isfinite(sphere.squared_radius)) {
      grid_.near(sphere.centre, std::sqrt(sphere.squared_radius) + 2 * look_beyond_, near_);
    }
    return sphere;
  }

  /// Whether centre_ and the circumradius are so near their approximations that no lift within the circumradius and
  /// `look_beyond_` of the true centre was missed.
  bool has_seen_enough(const ApproximateSphere<m>& sphere) const {
    const FilterGuard guard;
    Vector<Filter, m> approximate;
    for (std::size_t axis = 0; axis < m; ++axis) approximate[axis] = Filter::exactly(sphere.centre[axis]);
    const Filter error =
        square_root(filter_.squared_norm(difference(centre_, approximate))) +
        absolute(square_root(stack_squared_radius_) - square_root(Filter::exactly(sphere.squared_radius)));
    return is_proved(less(error, Filter::exactly(look_beyond_)));
  }

  void measure(std::size_t at, const std::optional<Rational>& required) {
    const auto& simplex = complex_.simplices()[at];
    least_margin_ = 0;
    const auto sphere = look_around(simplex);
    if (!std::isfinite(sphere.squared_radius) || !measure_shape(at) || !has_seen_enough(sphere)) {
      fail(simplex, nullptr, FailureCause::undecided, "cannot be told from a degenerate simplex");
      return;
    }
    measure_protection(at);
    if (!is_certain_) {
      certify_exactly(at);
    } else if (required) {
      require(at, *required);
    }
  }

  /// Circumradius and thickness; false if the filter cannot tell the simplex from a degenerate one.
  bool measure_shape(std::size_t at) {
    const FilterGuard guard;
    const auto vertices = positions<Filter>(complex_.simplices()[at]);
    SphereStack<Filter, m> stack(filter_);
    if (!is_proved(build<Filter>(stack, filter_, vertices, m))) return false;
    const Filter radius = square_root(stack.squared_radius());
    negated_radius_.include(-units_.upper(least_, radius.upper()), -units_.lower(least_, radius.lower()));
    stack_squared_radius_ = stack.squared_radius();
    centre_ = sum(stack.centre(), vertices[0]);
    return measure_thickness(vertices);
  }

  /// The altitude over a facet is ⟨n, e⟩/|n|, n normal to the facet and e an edge that leaves it; ⟨n, e⟩ is, up to its
  /// sign, the same for all facets.
  bool measure_thickness(const Corners<Filter, m>& vertices) {
    Filter longest(0);
    for (std::size_t a = 0; a < corners<m>; ++a) {
      for (std::size_t b = a + 1; b < corners<m>; ++b) {
        longest = maximum(longest, filter_.squared_norm(difference(vertices[b], vertices[a])));
      }
    }
    Filter slope(0);
    Filter largest(0);
    for (std::size_t apex = 0; apex < corners<m>; ++apex) {
      const std::size_t foot = apex == 0 ? 1 : 0;
      std::array<Vector<Filter, m>, static_cast<std::size_t>(m)> edges{};  // the last entry is not read
      std::size_t next = 0;
      for (std::size_t corner = 0; corner < corners<m>; ++corner) {
        if (corner != foot && corner != apex) edges[next++] = difference(vertices[corner], vertices[foot]);
      }
      const auto covector = wedge(edges);
      if (apex == 0) slope = filter_.determinant() * pairing(covector, difference(vertices[apex], vertices[foot]));
      largest = maximum(largest, filter_.squared_norm(filter_.raised(covector)));
    }
    if (!is_refuted(is_zero(slope))) return false;
    const Filter thickness = square_root(square(slope) / (largest * longest)) / Filter(m);
    thickness_.include(thickness.lower(), thickness.upper());
    return true;
  }

  void measure_protection(std::size_t at) {
    const auto& simplex = complex_.simplices()[at];
    const FilterGuard guard;
    const Filter radius = square_root(stack_squared_radius_);
    // Of the roots, which increase, only the least counts at either end.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double squared_lower = infinity;
    double squared_upper = infinity;
    for (const Lift<m>& lift : near_) {
      if (std::find(simplex.begin(), simplex.end(), lift) != simplex.end()) continue;
      const Filter squared = filter_.squared_norm(difference(position<Filter>(lift), centre_));
      if (squared.lower() < squared_lower) {
        squared_lower = squared.lower();
        nearest_ = lift;
      }
      squared_upper = std::min(squared_upper, squared.upper());
    }
    double lower = look_beyond_;
    double upper = look_beyond_;
    if (squared_upper < infinity) {
      const Filter margin = square_root(Filter::between(squared_lower, squared_upper)) - radius;
      lower = std::min(lower, margin.lower());
      upper = std::min(upper, margin.upper());
    }
    ladder_statistics().count(Rung::interval, near_.size());
    is_certain_ = lower > 0;
    least_margin_ = lower;
    if (is_certain_) protection_.include(units_.lower(least_, lower), units_.upper(least_, upper));
  }

  /// The filter did not find a positive margin: decides which lifts are outside at all.
  void certify_exactly(std::size_t at) {
    const auto& simplex = complex_.simplices()[at];
    const auto outside = []<class S>(const S& power, const S&) { return less(S(0), power); };
    for (const Lift<m>& lift : near_) {
      if (std::find(simplex.begin(), simplex.end(), lift) != simplex.end()) continue;
      const Verdict verdict = decide_power(simplex, lift, outside);
      if (is_proved(verdict)) continue;
      if (is_refuted(verdict)) {
        fail(simplex, &lift, FailureCause::occupied_ball, "has another point in its closed circumball");
      } else {
        fail(simplex, &lift, FailureCause::undecided, "is undecided");
      }
      return;
    }
    fail(simplex, &nearest_, FailureCause::undecided, "has a protection too small for the filter");
  }

  void require(std::size_t at, const Rational& required) {
    if (Rational::exactly(least_margin_) > scaled(required)) return;
    if (const auto lift = less_protected(at, scaled(required))) {
      fail(complex_.simplices()[at], &*lift, FailureCause::less_protected, "is less protected than required");
    }
  }

  void fail(const LiftedSimplex<m>& simplex, const Lift<m>* other, FailureCause cause, const std::string& reason) {
    StarFailure failure;
    failure.cause = cause;
    failure.label = Label(simplex[0].index);
    failure.reason = "simplex {";
    for (std::size_t corner = 0; corner < corners<m>; ++corner) {
      failure.reason += (corner > 0 ? ", " : "") + std::to_string(simplex[corner].index);
      failure.concerned.emplace_back(simplex[corner].index);
    }
    failure.reason += "} " + reason;
    if (other != nullptr) {
      failure.reason += ": label " + std::to_string(other->index);
      failure.concerned.emplace_back(other->index);
    }
    report_.failures.push_back(failure);
  }

  StarMargins margins() {
    StarMargins result;
    // Strictly below every margin, where nothing is left to show; then upwards as far as it holds, by bisection.
    const Rational lower = Rational::exactly(protection_.least);
    long best = index_below(lower);
    if (margin_number(best) == lower) --best;
    long beyond = index_below(Rational::exactly(protection_.least_upper)) + 1;
    while (beyond - best > 1) {
      const long middle = best + (beyond - best) / 2;
      (all_are_protected_by(margin_number(middle)) ? best : beyond) = middle;
    }
    result.protection = margin_number(best);
    // Of these two the filter's own bound is good enough: it is rounded to 12 digits, once.
    result.thickness = margin_number(index_below(Rational::exactly(thickness_.least)));
    const Rational radius = Rational::exactly(-negated_radius_.least);
    result.circumradius = rounded_up(radius, binary_exponent(radius) - margin_digits + 1);
    return result;
  }

  bool all_are_protected_by(const Rational& protection) {
    for (std::size_t at = 0; at < complex_.simplices().size(); ++at) {
      take_unit(complex_.simplices()[at]);
      if (Rational::exactly(lower_[at]) > scaled(protection)) continue;
      look_around(complex_.simplices()[at]);
      if (less_protected(at, scaled(protection))) return false;
    }
    return true;
  }

  /// A lift that is not farther from the circumcentre than the circumradius and `protection`, if there is one.
  /// Preconditions: near_ is that of the simplex, and the protection at most about `look_beyond_`.
  std::optional<Lift<m>> less_protected(std::size_t at, const Rational& protection) const {
    const auto& simplex = complex_.simplices()[at];
    const auto enough = [&protection]<class S>(const S& power, const S& squared_radius) {
      return is_outside_by(power, squared_radius, scalar_from<S>(protection));
    };
    for (const Lift<m>& lift : near_) {
      if (std::find(simplex.begin(), simplex.end(), lift) != simplex.end()) continue;
      if (!is_proved(decide_power(simplex, lift, enough))) return lift;
    }
    return std::nullopt;
  }

  const FlatAtlas<m>& atlas_;
  const PointSet<m>& points_;
  const StarComplex<m>& complex_;
  MetricOn<Filter, m> filter_;
  MetricOn<PlainDouble, m> plain_;
  const LengthUnits& units_;
  double half_radius_;
  const PointGrid<m>& grid_;

  Label least_{0};  // the vertex with the least unit, of the simplex at hand
  double look_beyond_ = 0;

  std::vector<Lift<m>> near_;
  Lift<m> nearest_;
  bool is_certain_ = false;
  double least_margin_ = 0;
  Filter stack_squared_radius_;
  Vector<Filter, m> centre_;

  std::vector<double> lower_;
  Extremes protection_;
  Extremes thickness_;
  Extremes negated_radius_;
  ProtectionReport report_;
};

}  // namespace

template <int m>
ProtectionReport certify_protection(const FlatAtlas<m>& atlas, const PointSet<m>& points, const StarComplex<m>& complex,
                                    const std::optional<Rational>& required_protection, const Progress& progress) {
  if (required_protection && Rational(2) * *required_protection > atlas.sampling_radius()) {
    throw InputError("a protection of " + exact_text(*required_protection) +
                     " cannot be required: it is looked for up to half the sampling radius only");
  }
  const Ground<m> ground(atlas, points, complex);
  Measurement<m> all(ground);
  in_parts<64>(
      "certify stars", complex.simplices().size(), progress,
      [&](std::size_t first, std::size_t last) {
        return Measurement<m>(ground).part(first, last, required_protection);
      },
      [&all](MeasuredPart part) { all.include(std::move(part)); });
  return all.report();
}

#define DELCERT_INSTANTIATE(m)                                                                                    \
  template ProtectionReport certify_protection<m>(const FlatAtlas<m>&, const PointSet<m>&, const StarComplex<m>&, \
                                                  const std::optional<Rational>&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
