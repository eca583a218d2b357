#include "kernel/simplex/exact_simplex.hpp"

#include <stdexcept>
#include <utility>

#include "kernel/simplex/realisability.hpp"

namespace delcert {

ExactSimplex ExactSimplex::from_points(Points points) {
  if (points.empty()) throw std::invalid_argument("a simplex needs at least one vertex");
  for (const auto& point : points) {
    if (point.empty() || point.size() != points.front().size()) {
      throw std::invalid_argument("points of different dimensions, or of dimension 0");
    }
  }
  ExactSimplex result;
  result.points_ = std::move(points);
  return result;
}

ExactSimplex ExactSimplex::from_points(Points points, SymmetricMatrix<Rational> metric) {
  ExactSimplex result = from_points(std::move(points));
  if (metric.order() != result.points_.front().size() || !is_proved(GramElimination<Rational>(metric).definite())) {
    throw std::invalid_argument("the metric is not a positive definite matrix of the dimension of the points");
  }
  result.metric_ = std::move(metric);
  return result;
}

ExactSimplex ExactSimplex::from_squared_edges(SymmetricMatrix<Rational> squared_edges) {
  for (std::size_t i = 0; i < squared_edges.order(); ++i) {
    if (!is_proved(is_zero(squared_edges(i, i)))) throw std::invalid_argument("a vertex away from itself");
  }
  const auto simplex = edge_gram_from_squared_edges(squared_edges);
  if (!is_proved(is_realisable(simplex, simplex.dimension()))) {
    throw std::invalid_argument("no simplex has these edge lengths");
  }
  ExactSimplex result;
  result.squared_edges_ = std::move(squared_edges);
  return result;
}

}  // namespace delcert
