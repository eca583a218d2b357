#pragma once

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

#include "kernel/number/ladder.hpp"
#include "kernel/simplex/edge_gram.hpp"
#include "tests/support/contains.hpp"
#include "tests/support/ratio.hpp"

namespace delcert {

inline void PrintTo(const Rational& x, std::ostream* stream) { *stream << x.wrapped(); }
inline void PrintTo(Verdict verdict, std::ostream* stream) { *stream << name_of(verdict); }
inline std::ostream& operator<<(std::ostream& stream, Verdict verdict) { return stream << name_of(verdict); }
inline std::ostream& operator<<(std::ostream& stream, const Rational& x) { return stream << x.wrapped(); }

}  // namespace delcert

namespace delcert::test {

using Points = std::vector<std::vector<Rational>>;

// Every run draws the same instances unless RC_PARAMS says otherwise.
inline const int fixed_seed = setenv("RC_PARAMS", "seed=20240229 max_success=300", 0);

inline const BigInterval::Precision precision{PrecisionBits{128}};

/// The points on another rung.
template <class S>
std::vector<std::vector<S>> points_on(const Points& points) {
  std::vector<std::vector<S>> result;
  for (const auto& point : points) {
    result.emplace_back();
    for (const Rational& coordinate : point) result.back().push_back(scalar_from<S>(coordinate));
  }
  return result;
}

/// The simplex on a rung, from coordinates in a Cartesian frame.
template <class S>
EdgeGram<S> simplex_on(const Points& points) {
  return edge_gram_from_points(points_on<S>(points));
}
inline EdgeGram<Rational> simplex_of(const Points& points) { return edge_gram_from_points(points); }

/// The regular k-simplex with edges √2: the unit vectors of ℝᵏ⁺¹.
inline Points regular_simplex(std::size_t k) {
  Points points(k + 1, std::vector<Rational>(k + 1));
  for (std::size_t i = 0; i <= k; ++i) points[i][i] = Rational(1);
  return points;
}

/// The right corner: the origin and the unit vectors of ℝᵏ, k ≥ 1.
inline Points right_corner(std::size_t k) {
  Points points(k + 1, std::vector<Rational>(k));
  for (std::size_t i = 0; i < k; ++i) points[i + 1][i] = Rational(1);
  return points;
}

/// What an interval says is either nothing or the truth.
inline bool agrees(Verdict on_intervals, Verdict exact) { return is_undecided(on_intervals) || on_intervals == exact; }

/// Dyadic, small-denominator or integer.
inline rc::Gen<Rational> any_coordinate() {
  return rc::gen::map(rc::gen::pair(rc::gen::inRange(-64, 65), rc::gen::element(1, 1, 2, 3, 5, 7, 8, 16, 1024)),
                      [](const std::pair<int, int>& parts) { return ratio(parts.first, parts.second); });
}

inline rc::Gen<Points> any_points(std::size_t count, std::size_t dimension) {
  return rc::gen::container<Points>(count, rc::gen::container<std::vector<Rational>>(dimension, any_coordinate()));
}

/// Vertices of a k-simplex in ℝᵐ, lowest ≤ k ≤ highest, k ≤ m ≤ k + 3, often degenerate or nearly so: some vertex may
/// be moved onto an affine combination of two others, give or take 2⁻ᵉ.
inline rc::Gen<Points> any_simplex(int lowest, int highest) {
  return rc::gen::exec([lowest, highest] {
    const auto k = static_cast<std::size_t>(*rc::gen::inRange(lowest, highest + 1));
    const auto m = k + static_cast<std::size_t>(*rc::gen::inRange(k == 0 ? 1 : 0, 4));
    Points points = *any_points(k + 1, m);
    const int kind = *rc::gen::inRange(0, 4);
    if (k >= 2 && kind >= 2) {
      const Rational weight = *any_coordinate();
      const Rational nudge = kind == 2 ? Rational(0) : Rational::power_of_two(-*rc::gen::inRange(1, 120));
      for (std::size_t axis = 0; axis < m; ++axis) {
        points[k][axis] = weight * points[0][axis] + (Rational(1) - weight) * points[1][axis];
      }
      points[k][m - 1] += nudge;
    }
    return points;
  });
}

}  // namespace delcert::test

namespace rc {
template <>
struct Arbitrary<delcert::Rational> {
  static Gen<delcert::Rational> arbitrary() { return delcert::test::any_coordinate(); }
};
}  // namespace rc
