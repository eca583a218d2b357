#include "proofs/checker/certificate/metric_field.hpp"

#include <algorithm>
#include <cmath>

#include "proofs/checker/arithmetic/exact_number.hpp"
#include "proofs/checker/report/budget.hpp"

namespace delcert::checker {
namespace {

SquareMatrix<Rational> parse_symmetric(Cursor& cursor, std::size_t m) {
  SquareMatrix<Rational> result(m);
  std::size_t i = 0;
  cursor.row(static_cast<int>(m), [&] {
    std::size_t k = 0;
    cursor.row(static_cast<int>(m), [&] { result(i, k++) = exact_value(cursor.number()); });
    ++i;
  });
  Report::require("form.gram", result == result.transposed(), "a matrix of the metric is not symmetric");
  return result;
}

Quantity parse_quantity(Cursor& cursor, std::string_view key) {
  cursor.expect(key);
  return Quantity(exact_value(cursor.number()));
}

/// scale * a, added to the sum.
template <class N, class M>
void add_multiple(SquareMatrix<N>& sum, const SquareMatrix<M>& a, const N& scale) {
  for (std::size_t i = 0; i < a.order(); ++i) {
    for (std::size_t k = 0; k < a.order(); ++k) sum(i, k) = sum(i, k) + N(a(i, k)) * scale;
  }
}

struct Turn {
  Ball cosine, sine;
};
/// Of 2 pi times the phase.
Turn turn(const Ball& phase) {
  Turn result;
  arb_sin_cos_pi(result.sine.raw(), result.cosine.raw(), (Ball(2) * phase).raw(), Ball::precision);
  return result;
}

/// Rounding upwards, it is not above the upper end.
double middle_of(const Interval& x) { return (x.lower() + x.upper()) / 2; }

constexpr double above_two_pi = 0x1.921fb54442d19p+2;

}  // namespace

MetricField::MetricField(int dimension, Cursor& cursor)
    : m(static_cast<std::size_t>(dimension)), constant(m), constant_filter(m) {
  cursor.expect(",\"constant\":");
  constant = parse_symmetric(cursor, m);
  constant_filter = enclosure(constant);
  cursor.expect(",\"waves\":");
  cursor.array([&] {
    Wave wave{
        {}, SquareMatrix<Rational>(m), SquareMatrix<Rational>(m), SquareMatrix<Interval>(m), SquareMatrix<Interval>(m)};
    cursor.expect("{\"frequency\":");
    cursor.row(dimension, [&] {
      const std::int64_t k = cursor.integer();
      if (k < -1000 || k > 1000) cursor.fail("form.types", "a frequency of at most 1000 before this");
      wave.frequency.push_back(static_cast<int>(k));
    });
    cursor.expect(",\"cosine\":");
    wave.cosine = parse_symmetric(cursor, m);
    cursor.expect(",\"sine\":");
    wave.sine = parse_symmetric(cursor, m);
    wave.cosine_filter = enclosure(wave.cosine);
    wave.sine_filter = enclosure(wave.sine);
    cursor.expect("}");
    waves.push_back(std::move(wave));
  });
  rounding = parse_quantity(cursor, ",\"rounding\":");
  patch_radius = parse_quantity(cursor, ",\"patch_radius\":");
  metric_distortion = parse_quantity(cursor, ",\"metric_distortion\":");
  const auto is_fraction = [](const Quantity& x) {
    return x.exact.sign() > 0 && less(x.exact, Rational(1)) == Verdict::proved;
  };
  Report::require("form.ranges", is_fraction(rounding), "rounding is not in (0, 1)");
  Report::require("form.ranges", is_fraction(metric_distortion), "metric_distortion is not in (0, 1)");
  Report::require("form.ranges", patch_radius.exact.sign() > 0, "patch_radius is not positive");
}

SquareMatrix<Ball> MetricField::at(const std::vector<Rational>& point) const {
  Budget::spend(1 + 500 * waves.size());
  SquareMatrix<Ball> result(m);
  add_multiple(result, constant, Ball(1));
  for (const Wave& wave : waves) {
    Rational phase(0);
    for (std::size_t k = 0; k < m; ++k) phase = phase + Rational(wave.frequency[k]) * point[k];
    const Turn turned = turn(Ball(phase));
    add_multiple(result, wave.cosine, turned.cosine);
    add_multiple(result, wave.sine, turned.sine);
  }
  return result;
}

SquareMatrix<Interval> MetricField::within(const Box& box) const {
  Budget::spend(1 + 200 * waves.size());
  SquareMatrix<Interval> result = constant_filter;
  for (const Wave& wave : waves) {
    double half_width = 0;
    std::array<double, 4> middle{};
    for (std::size_t k = 0; k < m; ++k) {
      middle[k] = middle_of(box[k]);
      const double half = std::max(box[k].upper() - middle[k], middle[k] - box[k].lower());
      half_width += std::abs(wave.frequency[k]) * half;
    }
    Interval cosine, sine;
    in_balls(64, [&] {
      Ball phase(0), x;
      for (std::size_t k = 0; k < m; ++k) {
        arb_set_d(x.raw(), middle[k]);
        phase = phase + Ball(wave.frequency[k]) * x;
      }
      const Turn turned = turn(phase);
      cosine = turned.cosine.enclosure();
      sine = turned.sine.enclosure();
    });
    // cos(a + b) = cos b cos a - sin b sin a, sin(a + b) = cos b sin a + sin b cos a; |b| <= h: cos b >= 1 - h^2/2,
    // |sin b| <= h.
    const double h = above_two_pi * half_width, slope = std::min(h, 1.0);
    const Interval bend = Interval(1) - Interval::between(0, std::min(h * h / 2, 2.0));
    const Interval sway = Interval::between(-slope, slope);
    add_multiple(result, wave.cosine_filter, bend * cosine + sway * sine);
    add_multiple(result, wave.sine_filter, bend * sine + sway * cosine);
  }
  return result;
}

bool holds_within(const MetricField& field, const Box& box, std::size_t most,
                  const std::function<Verdict(const SquareMatrix<Interval>&)>& property) {
  std::vector<Box> open{box};
  for (std::size_t looked_at = 0; !open.empty(); ++looked_at) {
    if (looked_at == most) throw Undecided("the metric is not known well enough on boxes");
    Box part = std::move(open.back());
    open.pop_back();
    const Verdict verdict = property(field.within(part));
    if (verdict == Verdict::proved) continue;
    if (verdict == Verdict::refuted) return false;
    Box point = part;
    std::size_t widest = 0;
    for (std::size_t k = 0; k < field.m; ++k) {
      const double middle = middle_of(part[k]);
      point[k] = Interval::between(middle, middle);
      if (part[k].upper() - part[k].lower() > part[widest].upper() - part[widest].lower()) widest = k;
    }
    if (property(field.within(point)) == Verdict::refuted) return false;
    Box lower = part;
    lower[widest] = Interval::between(part[widest].lower(), point[widest].upper());
    part[widest] = Interval::between(point[widest].lower(), part[widest].upper());
    open.push_back(std::move(lower));
    open.push_back(std::move(part));
  }
  return true;
}

SquareMatrix<Interval> enclosure(const SquareMatrix<Rational>& a) {
  SquareMatrix<Interval> result(a.order());
  for (std::size_t i = 0; i < a.order(); ++i) {
    for (std::size_t k = 0; k < a.order(); ++k) result(i, k) = enclosure(a(i, k));
  }
  return result;
}

}  // namespace delcert::checker
