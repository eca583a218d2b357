#pragma once

#include <cstddef>
#include <vector>

#include "kernel/simplex/edge_gram.hpp"
#include "kernel/simplex/gram_elimination.hpp"
#include "kernel/simplex/partial.hpp"

namespace delcert {

/// The smallest circumscribing ball: its centre C(σ) = Σ barycentric[i]·p_i (the coefficients add up to 1) and R(σ)².
template <Scalar S>
struct Circumsphere {
  std::vector<S> barycentric;
  S squared_radius;
};

namespace detail {
template <Scalar S>
[[nodiscard]] std::vector<S> half_diagonal(const EdgeGram<S>& simplex) {
  std::vector<S> result;
  for (std::size_t i = 1; i < simplex.vertex_count(); ++i) result.push_back(simplex.squared_edge(i, 0) / S(2));
  return result;
}
}  // namespace detail

/// C(σ) and R(σ)²: with G the Gram matrix and b half its diagonal, Gλ = b expresses |C − p_i| = |C − p_0| for
/// C = p_0 + Σ λ_i(p_i − p_0), and R² = bᵀλ (proof of lem:crude.rad.bnd).
///
/// A vertex has R = 0. A degenerate simplex may have one (four points of a circle do) or not (three points of a line):
/// decided exactly on exact scalars, where the coefficients are then one choice of many; on intervals absent where the
/// simplex may be degenerate.
template <Scalar S>
[[nodiscard]] Partial<Circumsphere<S>> circumsphere(const EdgeGram<S>& simplex) {
  const auto solution = GramElimination<S>(simplex.gram()).solve(detail::half_diagonal(simplex));
  if (!solution) return Partial<Circumsphere<S>>::absent(solution.exists());
  Circumsphere<S> result{{S(1)}, solution->energy};
  for (const S& coefficient : solution->x) {
    result.barycentric[0] = result.barycentric[0] - coefficient;
    result.barycentric.push_back(coefficient);
  }
  return result;
}

/// R(σ)²; absent as `circumsphere`.
template <Scalar S>
[[nodiscard]] Partial<S> squared_circumradius(const EdgeGram<S>& simplex) {
  return GramElimination<S>(simplex.gram()).energy(detail::half_diagonal(simplex));
}

/// R(σ), on the rungs that have square roots; absent as `circumsphere`.
template <Scalar S>
[[nodiscard]] Partial<S> circumradius(const EdgeGram<S>& simplex) {
  const Partial<S> squared = squared_circumradius(simplex);
  return squared ? Partial<S>(square_root(*squared)) : squared;
}

/// The coordinates of C(σ), for the points that the circumsphere was computed from.
template <class Points>
[[nodiscard]] std::vector<ScalarOfPoints<Points>> circumcentre(const Circumsphere<ScalarOfPoints<Points>>& sphere,
                                                               const Points& points) {
  using S = ScalarOfPoints<Points>;
  // Relative to the first point, so that intervals do not grow with the distance from the origin.
  std::vector<S> result;
  for (std::size_t axis = 0; axis < points[0].size(); ++axis) {
    S offset(0);
    for (std::size_t i = 1; i < points.size(); ++i) {
      offset = offset + sphere.barycentric[i] * (points[i][axis] - points[0][axis]);
    }
    result.push_back(points[0][axis] + offset);
  }
  return result;
}

}  // namespace delcert
