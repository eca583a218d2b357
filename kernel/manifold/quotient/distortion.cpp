#include "kernel/manifold/quotient/distortion.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <vector>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tolerance = 0x1p-10;
constexpr int most_boxes = 20'000;

/// sin a / a, 1, sinh a / a.
Interval ratio_at(Curvature curvature, const Interval& a) { return sine_ratio(curvature, square(a)); }

/// 4 sin²(x/2), x², 4 sinh²(x/2).
Interval squared_chord_of(Curvature curvature, const Interval& x) {
  return square(x * ratio_at(curvature, x / Interval(2)));
}

Interval stretch_of(Curvature curvature, const Interval& radius) {
  const Interval ratio = ratio_at(curvature, radius);
  return curvature == Curvature::positive ? Interval(1) / ratio : ratio;
}

/// The largest singular value where the first factor is p, the second 1/q, and sin² of the angle of the geodesics w.
Interval singular_value(const Interval& p, const Interval& q, const Interval& w) {
  const Interval product = p * q;
  const Interval bent = w * maximum((square(p) - Interval(1)) * (Interval(1) - square(q)), Interval(0));
  const Interval sum = square_root(square(Interval(1) + product) + bent);
  const Interval difference = square_root(square(Interval(1) - product) + bent);
  return (sum + difference) / Interval(2);
}

/// All points with distances a and b from the centres in a box.
struct Box {
  double first_lower, first_upper, second_lower, second_upper;
  double bound = infinity;

  friend bool operator<(const Box& a, const Box& b) { return a.bound < b.bound; }
};

/// Best first: the box with the greatest bound is divided, until that bound is close to a value that occurs.
class Search {
 public:
  Search(Curvature curvature, const Overlap& overlap)
      : curvature_(curvature),
        centres_(overlap.centres),
        squared_chord_(squared_chord_of(curvature, Interval::exactly(overlap.centres))) {
    // Where it is greatest (docs/distortion.md): on the line through the centres, as far from one as may be.
    const double near_second = std::max(0.0, overlap.from_first - overlap.centres);
    const double near_first = std::max(0.0, overlap.from_second - overlap.centres);
    if (near_second <= overlap.from_second) try_point(overlap.from_first, near_second);
    if (near_first <= overlap.from_first) try_point(near_first, overlap.from_second);
    add({0, overlap.from_first, 0, overlap.from_second});
  }

  Enclosed run() {
    for (int divided = 0; divided < most_boxes && !is_close(); ++divided) {
      const Box box = boxes_.top();
      boxes_.pop();
      const double first = box.first_lower / 2 + box.first_upper / 2;
      const double second = box.second_lower / 2 + box.second_upper / 2;
      for (const auto& [a0, a1] : {std::pair(box.first_lower, first), std::pair(first, box.first_upper)}) {
        for (const auto& [b0, b1] : {std::pair(box.second_lower, second), std::pair(second, box.second_upper)})
          add({a0, a1, b0, b1});
      }
    }
    return {lower_, std::max(lower_, boxes_.empty() ? 1 : boxes_.top().bound)};
  }

 private:
  [[nodiscard]] bool is_close() const {
    return boxes_.empty() || boxes_.top().bound <= lower_ + (lower_ - 1) * tolerance;
  }

  /// sin² of the greatest angle at a point with these distances from the centres, or a bound of it where distances are
  /// at least a and b and differ by at least `apart`. It is 1 for right and obtuse angles: for nearer centres a right
  /// one occurs.
  [[nodiscard]] Interval squared_sine(const Interval& a, const Interval& b, const Interval& apart) const {
    const Interval sides = a * ratio_at(curvature_, a) * b * ratio_at(curvature_, b);
    if (!(sides.lower() > 0)) return Interval(1);
    const Interval half = (squared_chord_ - squared_chord_of(curvature_, apart)) / (Interval(4) * sides);
    const Interval t = minimum(maximum(half, Interval(0)), Interval(1) / Interval(2));
    return Interval(4) * t * (Interval(1) - t);
  }

  void try_point(double a, double b) {
    const Interval first = Interval::exactly(a);
    const Interval second = Interval::exactly(b);
    const Interval apart = absolute(first - second);
    if (!(apart.upper() <= centres_)) return;
    const Interval value = singular_value(ratio_at(curvature_, first), Interval(1) / ratio_at(curvature_, second),
                                          squared_sine(first, second, apart));
    lower_ = std::max(lower_, value.lower());
  }

  /// The singular value grows with both factors and with sin² of the angle.
  void add(Box box) {
    const Interval a = Interval::exactly(box.first_lower);
    const Interval b = Interval::exactly(box.second_lower);
    const Interval apart =
        maximum(maximum(a - Interval::exactly(box.second_upper), b - Interval::exactly(box.first_upper)), Interval(0));
    if (apart.lower() > centres_) return;
    const bool grows = curvature_ == Curvature::negative;
    const Interval p = ratio_at(curvature_, grows ? Interval::exactly(box.first_upper) : a);
    const Interval q = Interval(1) / ratio_at(curvature_, grows ? b : Interval::exactly(box.second_upper));
    box.bound = singular_value(p, q, squared_sine(a, b, apart)).upper();
    boxes_.push(box);
    try_point(box.first_lower / 2 + box.first_upper / 2, box.second_lower / 2 + box.second_upper / 2);
  }

  Curvature curvature_;
  double centres_;
  Interval squared_chord_;
  double lower_ = 1;
  std::priority_queue<Box> boxes_;
};

double rounded_upwards(const Rational& x) { return scalar_from<Interval>(x).upper(); }

double above_one(const Interval& x) { return (x - Interval(1)).upper(); }

}  // namespace

double chart_stretch(Curvature curvature, const Rational& radius) {
  const RoundingGuard guard;
  return stretch_of(curvature, scalar_from<Interval>(radius)).upper();
}

double metric_distortion(Curvature curvature, const Rational& radius) {
  const RoundingGuard guard;
  const Interval ratio = ratio_at(curvature, scalar_from<Interval>(radius));
  return curvature == Curvature::positive ? (Interval(1) - ratio).upper() : above_one(ratio);
}

Enclosed greatest_stretch(Curvature curvature, const Overlap& overlap) {
  if (curvature == Curvature::zero) return {1, 1};
  const RoundingGuard guard;
  return Search(curvature, overlap).run();
}

TransitionDistortion transition_distortion(Curvature curvature, const Rational& patch_radius, const Rational& centres) {
  if (curvature == Curvature::zero) return {};
  const bool on_sphere = curvature == Curvature::positive;
  TransitionDistortion result;
  // Segments of a chart between points of both patches stay within this of the other centre.
  const Rational rest = Rational(1) - square(patch_radius) / Rational(6);
  const bool is_known = on_sphere ? patch_radius <= Rational(6) / Rational(5) : rest > Rational(0);
  Overlap overlap;
  {
    const RoundingGuard guard;
    const Interval radius = scalar_from<Interval>(patch_radius);
    const Interval far = ratio_at(curvature, radius);
    const Interval near = ratio_at(curvature, scalar_from<Interval>(patch_radius - centres));
    result.proved = above_one(stretch_of(curvature, radius));
    result.of_pairs = {((on_sphere ? near / far : far / near) - Interval(1)).lower(), result.proved};
    if (!is_known) return result;
    const Rational reach = on_sphere ? patch_radius : patch_radius / rest;
    overlap = {rounded_upwards(patch_radius), rounded_upwards(reach), rounded_upwards(centres)};
  }
  if (overlap.from_second > 3) return result;
  const Enclosed stretch = greatest_stretch(curvature, overlap);
  const RoundingGuard guard;
  result.of_pairs.upper = std::min(result.proved, above_one(Interval::exactly(stretch.upper)));
  return result;
}

double ball_distortion(Curvature curvature, const Rational& radius, const Rational& centres) {
  if (curvature == Curvature::zero) return 0;
  Overlap there;
  Overlap back;
  {
    const RoundingGuard guard;
    const Interval reach = scalar_from<Interval>(radius + centres);
    const double bound = curvature == Curvature::positive ? (straight_angle<Interval>() / Interval(2)).lower() : 3;
    if (!(reach.upper() < bound)) return infinity;
    const double segments = (stretch_of(curvature, reach) * scalar_from<Interval>(radius)).upper();
    if (!(segments < bound)) return infinity;
    there = {rounded_upwards(radius), reach.upper(), rounded_upwards(centres)};
    back = {reach.upper(), segments, there.centres};
  }
  const Enclosed stretch = greatest_stretch(curvature, there);
  const Enclosed shrinking = greatest_stretch(curvature, back);
  const RoundingGuard guard;
  const Interval one(1);
  return std::max(above_one(Interval::exactly(stretch.upper)),
                  (one - one / Interval::exactly(shrinking.upper)).upper());
}

}  // namespace delcert
