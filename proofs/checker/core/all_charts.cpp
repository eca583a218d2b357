#include "proofs/checker/core/all_charts.hpp"

namespace delcert::checker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Interval exactly(double x) { return Interval::between(x, x); }

/// The determinant of the Gram matrix of the edges at the first vertex; its trace; the greatest of the squares of the
/// inverse altitudes, times the determinant. `edge` has the vectors to the other vertices.
struct Gram {
  Interval determinant, trace, inverse_altitude;
};
template <class Product>
Gram gram_of(std::size_t m, const Product& product) {
  const auto g = [&](std::size_t i, std::size_t k) { return product(i, k); };
  if (m == 2) {
    const Interval a = g(0, 0), b = g(1, 1), c = g(0, 1);
    // Of the vertices 1, 2, 0.
    const Interval longest = maximum(maximum(b, a), a + b - c - c);
    return {a * b - square(c), a + b, longest};
  }
  const Interval a = g(0, 0), b = g(1, 1), c = g(2, 2), d = g(1, 2), e = g(0, 2), f = g(0, 1);
  const Interval A = b * c - square(d), B = a * c - square(e), C = a * b - square(f), D = e * f - a * d,
                 E = d * f - b * e, F = d * e - c * f, half = D + E + F;
  const Interval sum = A + B + C + half + half;
  return {a * A + f * F + e * E, a + b + c, maximum(maximum(A, B), maximum(C, sum))};
}

}  // namespace

SimplexInSpace SimplicesInSpace::of(std::uint32_t s) {
  const int K = complex_.data.K;
  const std::size_t m = complex_.data.m;
  const core::Lifts<Interval> lifts = complex_.lifts<Interval>(s);
  const core::Circumball<Interval> ball(complex_.data, form_, lifts);
  SimplexInSpace result;
  result.centre = ball.centre();
  // 1 / cos R = u, 1 / cosh R = u; the square of the chord of R is 2 |1 - 1/u|.
  const Interval bent = ball.tangent_squared();
  const Interval u = K == 0 ? Interval(1) : square_root(Interval(1) + Interval(K) * bent);
  const Interval radius = K == 0 ? bent : Interval(2) * bent / (u * (u + Interval(1)));
  around_.look(s, ball);
  const double power = around_.least(ball);
  result.radius = radius.upper();
  result.nearest = power < infinity ? (radius + Interval(2) * exactly(power) / u).lower() : infinity;
  std::array<Vector<Interval>, 3> edge{};
  double longest = 0;
  for (std::size_t k = 1; k <= m; ++k) {
    edge[k - 1] = lifts[k] - lifts[0];
    for (std::size_t other = 0; other < k; ++other)
      longest = std::max(longest, form_.squared(lifts[k] - lifts[other]).upper());
  }
  result.longest = longest;
  const Gram gram = gram_of(m, [&](std::size_t i, std::size_t k) { return form_.product(edge[i], edge[k]); });
  if (!(gram.determinant.lower() > 0)) return result;
  // The other eigenvalues have a product of at most (trace / (m - 1))^(m-1).
  const Interval mean = gram.trace / Interval(static_cast<int>(m) - 1);
  result.eigenvalue = (gram.determinant / (m == 2 ? mean : square(mean))).lower();
  result.altitude = (gram.determinant / gram.inverse_altitude).lower();
  return result;
}

AllCharts::AllCharts(int K, std::size_t m, const Quantity& reach)
    : K_(K), m_(m), is_narrow_(reach.filter.lower() > 0 && (K <= 0 || reach.filter.upper() < 1.5)) {
  if (K == 0 || !is_narrow_) return;
  const Interval ratio = in_balls(128, [&] { return (sine(K, Ball(reach.exact)) / Ball(reach.exact)).enclosure(); });
  (K > 0 ? most_ : least_) = Interval(1) / square(ratio);
}

AllCharts::Bounds AllCharts::bounds(const SimplexInSpace& simplex) const {
  Bounds result;
  const Interval width = most_ - least_, mean = (most_ + least_) / Interval(2);
  const int m = static_cast<int>(m_);
  // What the Gram matrix in a chart differs from its multiple in the space by.
  const Interval change = width * exactly(simplex.longest) * Interval(3 * m - 1) / Interval(4);
  const Interval eigenvalue = exactly(simplex.eigenvalue), left = mean * eigenvalue - change;
  if (!is_narrow_ || !(simplex.eigenvalue > 0) || !(left.lower() > 0) || !(simplex.nearest > 0)) return result;
  result.known = true;
  result.centre =
      (width * exactly(simplex.radius) * square_root(Interval(m)) / (Interval(2) * square_root(left))).upper();
  result.radius = (square_root(most_ * exactly(simplex.radius)) + exactly(result.centre)).upper();
  // On a sphere less than a quarter of a great circle away.
  const double nearest = K_ > 0 ? std::min(simplex.nearest, 2.0) : simplex.nearest;
  result.nearest =
      nearest < infinity ? (square_root(least_ * exactly(nearest)) - exactly(result.centre)).lower() : infinity;
  result.altitude = (left / eigenvalue * exactly(simplex.altitude)).lower();
  result.longest = (most_ * exactly(simplex.longest)).upper();
  return result;
}

bool AllCharts::fits(const SimplexInSpace& simplex, const Quantity& radius, const Quantity& thickness,
                     const Quantity& protection) const {
  const Bounds found = bounds(simplex);
  if (!found.known || !(found.radius <= radius.filter.lower())) return false;
  const Interval least = square(thickness.filter * Interval(static_cast<int>(m_))) * exactly(found.longest);
  const Interval enlarged = exactly(found.radius) + protection.filter;
  return least.upper() <= found.altitude && enlarged.upper() < found.nearest;
}

double AllCharts::squared_chord(double length) const {
  if (!(length > 0)) return 0;
  const Interval squared = square(exactly(length));
  return (K_ > 0 ? squared * (Interval(1) - squared / Interval(12)) : squared).lower();
}

}  // namespace delcert::checker
