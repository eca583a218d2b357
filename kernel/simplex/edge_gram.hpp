#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "kernel/simplex/symmetric_matrix.hpp"

namespace delcert {

/// A k-simplex up to isometry: the Gram matrix of its edge vectors from vertex 0 and all its squared edge lengths.
///
/// Every quantity of this folder that does not mention coordinates is computed from it, so that coordinates in any
/// metric and edge lengths are served alike. The vertices may coincide or be dependent. Lengths that no simplex has
/// are possible too (see `is_realisable`); all other functions presuppose realisable ones.
template <Scalar S>
class EdgeGram {
 public:
  /// Precondition: the two describe the same simplex; squared_edges is of one order more than gram.
  EdgeGram(SymmetricMatrix<S> gram, SymmetricMatrix<S> squared_edges)
      : gram_(std::move(gram)), squared_edges_(std::move(squared_edges)) {}

  [[nodiscard]] std::size_t dimension() const { return gram_.order(); }
  [[nodiscard]] std::size_t vertex_count() const { return squared_edges_.order(); }
  /// |p_i − p_j|²; 0 for i = j.
  [[nodiscard]] const S& squared_edge(std::size_t i, std::size_t j) const { return squared_edges_(i, j); }

  /// ⟨p_i − p_base, p_j − p_base⟩.
  [[nodiscard]] S product(std::size_t base, std::size_t i, std::size_t j) const {
    if (i == j) return squared_edges_(i, base);
    if (i == base || j == base) return S(0);
    if (base == 0) return gram_(i - 1, j - 1);
    return (squared_edges_(base, i) + squared_edges_(base, j) - squared_edges_(i, j)) / S(2);
  }

  /// PᵀP for the matrix P whose columns are p_i − p_0, i = 1 … k.
  [[nodiscard]] const SymmetricMatrix<S>& gram() const { return gram_; }
  /// All |p_i − p_j|².
  [[nodiscard]] const SymmetricMatrix<S>& squared_edge_matrix() const { return squared_edges_; }

  /// The face of the given distinct vertices; its vertices are numbered as they are listed. At least one.
  [[nodiscard]] EdgeGram face(std::span<const std::size_t> vertices) const {
    if (vertices.empty()) throw std::invalid_argument("a face needs at least one vertex");
    const std::size_t k = vertices.size() - 1;
    SymmetricMatrix<S> gram(k);
    SymmetricMatrix<S> squared_edges(k + 1);
    for (std::size_t i = 1; i <= k; ++i) {
      for (std::size_t j = 0; j < i; ++j) squared_edges(i, j) = squared_edges_(vertices[i], vertices[j]);
      for (std::size_t j = 1; j <= i; ++j) gram(i - 1, j - 1) = product(vertices[0], vertices[i], vertices[j]);
    }
    return EdgeGram(std::move(gram), std::move(squared_edges));
  }
  [[nodiscard]] EdgeGram face(std::initializer_list<std::size_t> vertices) const {
    return face(std::span<const std::size_t>(vertices.begin(), vertices.size()));
  }

  /// The facet without vertex p, the other vertices in their order. Precondition: dimension() ≥ 1.
  [[nodiscard]] EdgeGram opposite_facet(std::size_t p) const {
    std::vector<std::size_t> vertices;
    vertices.reserve(vertex_count() - 1);
    for (std::size_t i = 0; i < vertex_count(); ++i) {
      if (i != p) vertices.push_back(i);
    }
    return face(vertices);
  }

 private:
  SymmetricMatrix<S> gram_;
  SymmetricMatrix<S> squared_edges_;
};

/// The scalar of a list of points: any `points[i][axis]` with `size()` on both levels.
template <class Points>
using ScalarOfPoints = std::remove_cvref_t<decltype(std::declval<const Points&>()[0][0])>;

/// The simplex of the given points of ℝᵐ, m ≥ 1, under the inner product that the callable `inner` computes
/// from two difference vectors.
template <class Points, class Inner>
[[nodiscard]] auto edge_gram_from_points(const Points& points, const Inner& inner) -> EdgeGram<ScalarOfPoints<Points>> {
  using S = ScalarOfPoints<Points>;
  if (points.size() == 0) throw std::invalid_argument("a simplex needs at least one vertex");
  const auto edge = [&points](std::size_t to, std::size_t from) {
    if (points[to].size() != points[0].size()) throw std::invalid_argument("points of different dimensions");
    std::vector<S> vector;
    for (std::size_t axis = 0; axis < points[0].size(); ++axis) vector.push_back(points[to][axis] - points[from][axis]);
    return vector;
  };
  const std::size_t k = points.size() - 1;
  SymmetricMatrix<S> gram(k);
  SymmetricMatrix<S> squared_edges(k + 1);
  std::vector<std::vector<S>> from_origin;
  for (std::size_t i = 1; i <= k; ++i) {
    from_origin.push_back(edge(i, 0));
    for (std::size_t j = 1; j < i; ++j) {
      gram(i - 1, j - 1) = inner(from_origin[i - 1], from_origin[j - 1]);
      const std::vector<S> side = edge(i, j);
      squared_edges(i, j) = inner(side, side);
    }
    gram(i - 1, i - 1) = squared_edges(i, 0) = inner(from_origin[i - 1], from_origin[i - 1]);
  }
  return EdgeGram<S>(std::move(gram), std::move(squared_edges));
}

/// The simplex of the given points in Cartesian coordinates.
template <class Points>
[[nodiscard]] auto edge_gram_from_points(const Points& points) -> EdgeGram<ScalarOfPoints<Points>> {
  using S = ScalarOfPoints<Points>;
  return edge_gram_from_points(points, [](const std::vector<S>& x, const std::vector<S>& y) {
    S sum(0);
    for (std::size_t axis = 0; axis < x.size(); ++axis) sum = sum + (&x == &y ? square(x[axis]) : x[axis] * y[axis]);
    return sum;
  });
}

/// The same of rational points, in integers over a common denominator where that is not too long: many times faster
/// than in fractions, each of which is reduced after each operation.
[[nodiscard]] EdgeGram<Rational> edge_gram_from_points(const std::vector<std::vector<Rational>>& points);

/// The simplex of points given in a frame with the inner product ⟨x, y⟩ = xᵀGy, G the positive definite `metric`.
template <class Points>
[[nodiscard]] auto edge_gram_from_points(const Points& points, const SymmetricMatrix<ScalarOfPoints<Points>>& metric)
    -> EdgeGram<ScalarOfPoints<Points>> {
  using S = ScalarOfPoints<Points>;
  return edge_gram_from_points(points, [&metric](const std::vector<S>& x, const std::vector<S>& y) {
    S sum(0);
    for (std::size_t row = 0; row < x.size(); ++row) {
      S image(0);
      for (std::size_t column = 0; column < y.size(); ++column) image = image + metric(row, column) * y[column];
      sum = sum + x[row] * image;
    }
    return sum;
  });
}

/// The simplex with the squared edge lengths |p_i − p_j|² = squared_edges(i, j); its order is the number of vertices,
/// at least 1, and its diagonal is 0. Whether such a simplex exists is not asked here.
template <Scalar S>
[[nodiscard]] EdgeGram<S> edge_gram_from_squared_edges(SymmetricMatrix<S> squared_edges) {
  if (squared_edges.order() == 0) throw std::invalid_argument("a simplex needs at least one vertex");
  SymmetricMatrix<S> gram(squared_edges.order() - 1);
  for (std::size_t i = 1; i < squared_edges.order(); ++i) {
    gram(i - 1, i - 1) = squared_edges(i, 0);
    for (std::size_t j = 1; j < i; ++j) {
      gram(i - 1, j - 1) = (squared_edges(i, 0) + squared_edges(j, 0) - squared_edges(i, j)) / S(2);
    }
  }
  return EdgeGram<S>(std::move(gram), std::move(squared_edges));
}

}  // namespace delcert
