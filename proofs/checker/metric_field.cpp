#include "proofs/checker/metric_field.hpp"

#include "proofs/checker/exact_number.hpp"

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

Ball symmetric_ball(const Ball& radius) {
  Ball result(0);
  arb_add_error(result.raw(), radius.raw());
  return result;
}

/// x, or 1 if x may be larger.
Ball cut_off_at_one(const Ball& x) { return less(x, Ball(1)) == Verdict::proved ? x : Ball(1); }

}  // namespace

MetricField::MetricField(int dimension, Cursor& cursor) : m(static_cast<std::size_t>(dimension)), constant(m) {
  cursor.expect(",\"constant\":");
  constant = parse_symmetric(cursor, m);
  cursor.expect(",\"waves\":");
  cursor.array([&] {
    Wave wave{{}, SquareMatrix<Rational>(m), SquareMatrix<Rational>(m)};
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

SquareMatrix<Ball> MetricField::within(const Box& box) const {
  SquareMatrix<Ball> result(m);
  const auto add = [&](const SquareMatrix<Rational>& matrix, const Ball& factor) {
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t k = 0; k < m; ++k) {
        if (matrix(i, k).sign() != 0) result(i, k) = result(i, k) + Ball(matrix(i, k)) * factor;
      }
    }
  };
  add(constant, Ball(1));
  for (const Wave& wave : waves) {
    Rational middle(0), half_width(0);
    for (std::size_t k = 0; k < m; ++k) {
      middle = middle + Rational(wave.frequency[k]) * box.middle[k];
      half_width = half_width + Rational(std::abs(wave.frequency[k])) * box.half_widths[k];
    }
    Ball sine, cosine, pi;
    arb_sin_cos_pi(sine.raw(), cosine.raw(), Ball(Rational(2) * middle).raw(), Ball::precision);
    if (half_width.sign() != 0) {
      // cos(a + b) = cos a - (1 - cos b) cos a - sin b sin a, with |b| <= h: |1 - cos b| <= h^2/2, |sin b| <= h.
      arb_const_pi(pi.raw(), Ball::precision);
      const Ball h = Ball(2) * pi * Ball(half_width);
      const Ball bend = symmetric_ball(square(h) / Ball(2)), slope = symmetric_ball(cut_off_at_one(h));
      const Ball before = cosine;
      cosine = cosine + bend * cosine + slope * sine;
      sine = sine + bend * sine + slope * before;
    }
    add(wave.cosine, cosine);
    add(wave.sine, sine);
  }
  return result;
}

bool holds_within(const MetricField& field, const Box& box, std::size_t most,
                  const std::function<Verdict(const SquareMatrix<Ball>&)>& property) {
  const BallScope scope(64);
  const Rational half = Rational(1) / Rational(2);
  std::vector<Box> open{box};
  for (std::size_t looked_at = 0; !open.empty(); ++looked_at) {
    if (looked_at == most) throw Undecided("the metric is not known well enough on boxes");
    const Box part = std::move(open.back());
    open.pop_back();
    const Verdict verdict = property(field.within(part));
    if (verdict == Verdict::proved) continue;
    const std::vector<Rational> point(field.m);
    if (verdict == Verdict::refuted || property(field.within({part.middle, point})) == Verdict::refuted) return false;
    std::size_t widest = 0;
    for (std::size_t k = 1; k < field.m; ++k) {
      if (less(part.half_widths[widest], part.half_widths[k]) == Verdict::proved) widest = k;
    }
    for (const int side : {-1, 1}) {
      Box next = part;
      next.half_widths[widest] = next.half_widths[widest] * half;
      next.middle[widest] = next.middle[widest] + Rational(side) * next.half_widths[widest];
      open.push_back(std::move(next));
    }
  }
  return true;
}

SquareMatrix<Rational> upper_triangle(std::size_t m, const std::vector<Rational>& entries) {
  SquareMatrix<Rational> result(m);
  std::size_t next = 0;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = i; k < m; ++k) result(i, k) = entries[next++];
  }
  return result;
}

SquareMatrix<Rational> inverse_of_triangle(const SquareMatrix<Rational>& a) {
  const std::size_t m = a.order();
  SquareMatrix<Rational> result(m);
  for (std::size_t k = 0; k < m; ++k) {
    result(k, k) = Rational(1) / a(k, k);
    for (std::size_t i = k; i-- > 0;) {
      Rational sum(0);
      for (std::size_t j = i + 1; j <= k; ++j) sum = sum + a(i, j) * result(j, k);
      result(i, k) = -sum / a(i, i);
    }
  }
  return result;
}

}  // namespace delcert::checker
