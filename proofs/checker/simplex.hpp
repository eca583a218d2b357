#pragma once

#include <vector>

#include "proofs/checker/metric.hpp"

namespace delcert::checker {

template <class N>
using Matrix = std::array<std::array<N, 4>, 4>;

/// Replaces the leading k x k block of a symmetric matrix by its inverse. Proved: it is positive definite and inverted;
/// refuted: it is not positive definite; undecided: the filter cannot tell. Only after `proved` is the result defined.
/// (The sweep operator; its pivots are those of the Cholesky decomposition.)
template <class N>
Verdict invert(Matrix<N>& a, int k) {
  const auto size = static_cast<std::size_t>(k);
  for (std::size_t p = 0; p < size; ++p) {
    const Verdict positive = less(N(0), a[p][p]);
    if (positive != Verdict::proved) return positive;
    const std::array<N, 4> row = a[p];
    for (std::size_t i = 0; i < size; ++i) {
      if (i == p) continue;
      a[i][p] = a[p][i] = row[i] / row[p];
      for (std::size_t j = 0; j < size; ++j) {
        if (j != p) a[i][j] = a[i][j] - a[i][p] * row[j];
      }
    }
    a[p][p] = -(N(1) / row[p]);
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) a[i][j] = -a[i][j];
  }
  return Verdict::proved;
}

/// A k-simplex in R^m, 1 <= k <= m <= 4, by its vertices relative to any origin: everything that the levels ask about
/// it.
template <class N>
class Simplex {
 public:
  /// Nothing but `non_degenerate` may be asked unless that is proved. (Undecided occurs in the filter only.)
  Simplex(const Metric& metric, const std::vector<Vector<N>>& vertices);

  /// The enclosure of an exact simplex.
  explicit Simplex(const Simplex<Rational>& exact) requires std::is_same_v<N, Interval>;

  Verdict non_degenerate = Verdict::undecided;
  Vector<N> centre{};             // the circumcentre relative to the first vertex
  N radius_squared{0};            // of the circumscribed ball
  N longest_squared{0};           // of the edges
  N inverse_altitude_squared{0};  // 1 / (the least altitude)^2

  /// thickness >= sqrt(threshold_squared), where the thickness is the least altitude / (k longest edge); 1 if k = 1.
  Verdict thicker_than(const N& threshold_squared) const {
    return less_equal(threshold_squared * N(k_ * k_) * longest_squared * inverse_altitude_squared, N(1));
  }

  /// The squared distance from the affine hull to a point at x from the first vertex.
  N squared_height(const Metric& metric, const Vector<N>& x) const;

 private:
  friend class Simplex<Interval>;
  int k_;
  std::array<Vector<N>, 4> edges_{};
  Matrix<N> inverse_{};  // of the Gram matrix of the edges from the first vertex
};

template <class N>
Simplex<N>::Simplex(const Metric& metric, const std::vector<Vector<N>>& vertices)
    : k_(static_cast<int>(vertices.size()) - 1) {
  const auto k = static_cast<std::size_t>(k_), m = static_cast<std::size_t>(metric.dimension());
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t a = 0; a < m; ++a) edges_[i][a] = vertices[i + 1][a] - vertices[0][a];
  }
  Matrix<N> gram{};
  for (std::size_t i = 0; i < k; ++i) {
    gram[i][i] = metric.squared_length(edges_[i]);
    longest_squared = maximum(longest_squared, gram[i][i]);
    for (std::size_t j = 0; j < i; ++j) {
      gram[i][j] = gram[j][i] = metric.product(edges_[i], edges_[j]);
      longest_squared = maximum(longest_squared, gram[i][i] + gram[j][j] - N(2) * gram[i][j]);
    }
  }
  inverse_ = gram;
  non_degenerate = invert(inverse_, k_);
  if (non_degenerate != Verdict::proved) return;
  // The altitude from vertex i + 1 is inverse_[i][i]^(-1/2): the rows of the dual basis are the gradients of the
  // barycentric coordinates, the one of vertex 0 minus their sum. The circumcentre is sum b_i e_i with 2 M b = diag M.
  N all(0);
  for (std::size_t i = 0; i < k; ++i) {
    N coordinate(0);
    for (std::size_t j = 0; j < k; ++j) {
      coordinate = coordinate + inverse_[i][j] * gram[j][j];
      all = all + inverse_[i][j];
    }
    coordinate = coordinate / N(2);
    radius_squared = radius_squared + coordinate * gram[i][i] / N(2);
    for (std::size_t a = 0; a < m; ++a) centre[a] = centre[a] + coordinate * edges_[i][a];
    inverse_altitude_squared = maximum(inverse_altitude_squared, inverse_[i][i]);
  }
  inverse_altitude_squared = maximum(inverse_altitude_squared, all);
}

template <class N>
Simplex<N>::Simplex(const Simplex<Rational>& exact) requires std::is_same_v<N, Interval>
    : non_degenerate(exact.non_degenerate),
      radius_squared(enclosure(exact.radius_squared)),
      longest_squared(enclosure(exact.longest_squared)),
      inverse_altitude_squared(enclosure(exact.inverse_altitude_squared)),
      k_(exact.k_) {
  for (std::size_t i = 0; i < 4; ++i) {
    centre[i] = enclosure(exact.centre[i]);
    for (std::size_t j = 0; j < 4; ++j) {
      edges_[i][j] = enclosure(exact.edges_[i][j]);
      inverse_[i][j] = enclosure(exact.inverse_[i][j]);
    }
  }
}

template <class N>
N Simplex<N>::squared_height(const Metric& metric, const Vector<N>& x) const {
  if (k_ == metric.dimension()) return N(0);
  const auto k = static_cast<std::size_t>(k_);
  N squared = metric.squared_length(x);
  Vector<N> products{};
  for (std::size_t i = 0; i < k; ++i) products[i] = metric.product(edges_[i], x);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) squared = squared - products[i] * inverse_[i][j] * products[j];
  }
  return squared;
}

}  // namespace delcert::checker
