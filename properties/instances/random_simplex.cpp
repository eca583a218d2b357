#include "properties/instances/random_simplex.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "kernel/number/ladder.hpp"
#include "kernel/simplex/dual_basis.hpp"
#include "kernel/simplex/independence.hpp"
#include "kernel/simplex/thickness.hpp"
#include "properties/instances/exact_point.hpp"

namespace delcert {

namespace {

using Points = SimplexObject::Points;
using Point = std::vector<Rational>;

constexpr unsigned coordinate_bits = 24;
constexpr long thinnest = 100;

enum class Family : unsigned char { generic, integers, corner, near_hull, cluster, squashed };
constexpr long family_count = 6;

Point random_point(std::size_t dimension, Choices& choices) {
  Point point;
  for (std::size_t axis = 0; axis < dimension; ++axis) point.push_back(choices.symmetric(coordinate_bits));
  return point;
}

/// The last vertex at a distance of about 2^−depth from the hull of the others, or of some of them.
void move_near_hull(Points& points, Choices& choices) {
  const long depth = choices.between(1, thinnest);
  Point near = points[0];
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (choices.happens(0.25)) continue;
    near = combined(near, choices.symmetric(6), combined(points[i], Rational(-1), points[0]));
  }
  points.back() = combined(near, Rational::power_of_two(-depth), points.back());
}

/// Some vertices at a distance of about 2^−depth from the first.
void gather(Points& points, Choices& choices) {
  const Rational scale = Rational::power_of_two(-choices.between(1, thinnest));
  const auto last = static_cast<std::size_t>(choices.between(1, static_cast<long>(points.size()) - 1));
  for (std::size_t i = 1; i <= last; ++i) points[i] = combined(points[0], scale, points[i]);
}

void squash(Points& points, Choices& choices) {
  for (std::size_t axis = 0; axis < points[0].size(); ++axis) {
    if (choices.happens(0.5)) continue;
    const Rational scale = Rational::power_of_two(-choices.between(1, thinnest));
    for (Point& point : points) point[axis] *= scale;
  }
}

void place(Points& points, Choices& choices) {
  if (choices.happens(0.1)) {
    const Rational scale = Rational::power_of_two(choices.between(-60, 60));
    for (Point& point : points) {
      for (Rational& coordinate : point) coordinate *= scale;
    }
  }
  if (choices.happens(0.1)) {
    const Rational scale = Rational::power_of_two(choices.between(0, 40));
    const Point shift = random_point(points[0].size(), choices);
    for (Point& point : points) point = combined(point, scale, shift);
  }
}

Rational in_lowest_bits(const Rational& x, long exponent) {
  // To the nearer multiple of 2^exponent.
  return rounded_down(x + Rational::power_of_two(exponent - 1), exponent);
}

}  // namespace

std::optional<Points> random_simplex(const Shape& shape, Choices& choices) {
  const auto k = static_cast<std::size_t>(shape.k);
  const auto m = static_cast<std::size_t>(shape.m);
  const auto family = static_cast<Family>(choices.between(0, family_count - 1));
  Points points;
  for (std::size_t i = 0; i <= k; ++i) points.push_back(random_point(m, choices));
  if (family == Family::integers || family == Family::corner) {
    for (Point& point : points) {
      for (Rational& coordinate : point) coordinate = Rational(floor_of(coordinate * Rational(4)));
    }
  }
  if (family == Family::corner) {
    for (std::size_t i = 0; i <= k; ++i) {
      for (std::size_t axis = 0; axis < m; ++axis) points[i][axis] = Rational(i == axis + 1 ? 1 : 0);
    }
    if (m > k) points[0][m - 1] = Rational(choices.between(0, 1));
  }
  if (family == Family::near_hull) move_near_hull(points, choices);
  if (family == Family::cluster) gather(points, choices);
  if (family == Family::squashed) squash(points, choices);
  place(points, choices);
  if (!are_affinely_independent(points)) return std::nullopt;
  return points;
}

void put_high_vertex_first(Points& points) {
  const auto k = static_cast<Eigen::Index>(points.size()) - 1;
  const auto m = static_cast<Eigen::Index>(points.front().size());
  Eigen::MatrixXd edges(m, k);
  for (Eigen::Index i = 0; i < k; ++i) {
    for (Eigen::Index axis = 0; axis < m; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      edges(axis, i) = approximate_double(points[static_cast<std::size_t>(i) + 1][at] - points[0][at]);
    }
  }
  // The rows of the pseudo-inverse have the inverse altitudes for lengths, those of R⁻¹ have the same lengths.
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(edges);
  const Eigen::MatrixXd inverse = factors.matrixR().topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(
      Eigen::MatrixXd::Identity(k, k).eval());
  const Eigen::MatrixXd duals = factors.colsPermutation() * inverse;
  double least = duals.colwise().sum().squaredNorm();
  std::size_t highest = 0;
  for (Eigen::Index i = 0; i < k; ++i) {
    const double here = duals.row(i).squaredNorm();
    if (here < least) {
      least = here;
      highest = static_cast<std::size_t>(i) + 1;
    }
  }
  std::swap(points[0], points[highest]);
}

std::set<Trait> traits_of(const SimplexObject& simplex) {
  const EdgeGram<Rational>& gram = simplex.exact_gram();
  const Rational thin = Rational::power_of_two(-40);
  Verdict thick = Verdict::undecided;
  {
    const FilterGuard guard;
    thick = is_thickness_at_least(
        EdgeGram<Filter>(matrix_from<Filter>(gram.gram()), matrix_from<Filter>(gram.squared_edge_matrix())),
        scalar_from<Filter>(thin));
  }
  if (is_undecided(thick)) {
    const auto basis = DualBasis::of(gram);
    thick = verdict_of(basis && basis->squared_thickness() >= thin);
  }
  std::set<Trait> traits;
  if (is_refuted(thick)) traits.insert(Trait::nearly_degenerate);
  return traits;
}

std::vector<Rational> simpler_numbers(const Rational& number) {
  std::vector<Rational> result;
  if (number == Rational(0)) return result;
  const long exponent = binary_exponent(number);
  const Rational sign(number < Rational(0) ? -1 : 1);
  const auto add = [&](const Rational& candidate) {
    const bool is_new = std::find(result.begin(), result.end(), candidate) == result.end();
    if (candidate != number && is_new) result.push_back(candidate);
  };
  add(sign);
  for (const long halvings : {1L, 2L, 3L, 4L, 8L, 16L, 32L, 64L, 128L}) {
    if (halvings < -exponent) add(sign * Rational::power_of_two(-halvings));
  }
  if (exponent != 0) add(sign * Rational::power_of_two(exponent));
  for (const long bits : {0L, 1L, 3L, 7L, 15L, 30L, 60L}) add(rounded_down(number, exponent - bits));
  return result;
}

std::vector<Points> simpler_points(const Points& points, std::size_t least_points, std::size_t least_dimension) {
  std::vector<Points> result;
  const std::size_t dimension = points.front().size();
  for (std::size_t i = 0; points.size() > least_points && i < points.size(); ++i) {
    result.push_back(points);
    result.back().erase(result.back().begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (std::size_t axis = 0; dimension > least_dimension && axis < dimension; ++axis) {
    result.push_back(points);
    for (Point& point : result.back()) point.erase(point.begin() + static_cast<std::ptrdiff_t>(axis));
  }
  result.push_back(points);
  for (Point& point : result.back()) point = combined(point, Rational(-1), points[0]);
  Rational greatest(0);
  for (const Point& point : points) {
    for (const Rational& coordinate : point) greatest = maximum(greatest, absolute(coordinate));
  }
  if (greatest == Rational(0)) return result;
  const long exponent = binary_exponent(greatest);
  result.push_back(points);
  for (Point& point : result.back()) {
    for (Rational& coordinate : point) coordinate *= Rational::power_of_two(-exponent);
  }
  for (const long bits : {0L, 1L, 2L, 3L, 5L, 8L, 12L, 20L, 40L, 80L}) {
    result.push_back(points);
    for (Point& point : result.back()) {
      for (Rational& coordinate : point) coordinate = in_lowest_bits(coordinate, exponent - bits);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      const Rational& coordinate = points[i][axis];
      if (coordinate == Rational(0)) continue;
      std::vector<Rational> candidates = simpler_numbers(coordinate);
      candidates.insert(candidates.begin(), Rational(0));
      for (const Rational& candidate : candidates) {
        if (candidate == coordinate) continue;
        result.push_back(points);
        result.back()[i][axis] = candidate;
      }
    }
  }
  return result;
}

std::vector<Shape> simplex_shapes() {
  std::vector<Shape> result;
  for (int k = 1; k <= 6; ++k) {
    for (int m = k; m <= k + 3; ++m) result.push_back({k, m});
  }
  return result;
}

}  // namespace delcert
