#pragma once

#include <optional>
#include <vector>

#include "kernel/number/ladder.hpp"
#include "kernel/simplex/edge_gram.hpp"

namespace delcert {

/// A simplex given exactly, by rational coordinates in a frame with a rational inner product or by rational squared
/// edge lengths, from which every rung of the ladder gets its own `EdgeGram`.
class ExactSimplex {
 public:
  using Points = std::vector<std::vector<Rational>>;

  /// Cartesian coordinates. Throws std::invalid_argument unless there is a vertex and all have the same dimension.
  [[nodiscard]] static ExactSimplex from_points(Points points);
  /// Coordinates in a frame with ⟨x, y⟩ = xᵀGy. Throws std::invalid_argument also if the metric does not fit.
  [[nodiscard]] static ExactSimplex from_points(Points points, SymmetricMatrix<Rational> metric);
  /// Squared edge lengths, of the order of the number of vertices. Throws std::invalid_argument unless the diagonal
  /// is 0 and some Euclidean space has such a simplex.
  [[nodiscard]] static ExactSimplex from_squared_edges(SymmetricMatrix<Rational> squared_edges);

  /// Precondition for S = Interval: a `RoundingGuard` is alive.
  template <Scalar S>
  [[nodiscard]] EdgeGram<S> on() const {
    if (points_.empty()) return edge_gram_from_squared_edges(matrix_from<S>(*squared_edges_));
    std::vector<std::vector<S>> points;
    for (const auto& exact : points_) {
      points.emplace_back();
      for (const Rational& coordinate : exact) points.back().push_back(scalar_from<S>(coordinate));
    }
    return metric_ ? edge_gram_from_points(points, matrix_from<S>(*metric_)) : edge_gram_from_points(points);
  }

 private:
  ExactSimplex() = default;
  Points points_;
  std::optional<SymmetricMatrix<Rational>> metric_;
  std::optional<SymmetricMatrix<Rational>> squared_edges_;
};

/// Decides a predicate about a simplex on the lowest rung that can: `predicate(EdgeGram<S>)` is a generic callable
/// that returns the verdict on rung S. With rational parameters the last rung always decides.
template <class Predicate>
[[nodiscard]] Verdict decide_on(const ExactSimplex& simplex, const Predicate& predicate) {
  return decide([&]<class S>() { return predicate(simplex.on<S>()); });
}

}  // namespace delcert
