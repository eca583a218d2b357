#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/simplex/edge_gram.hpp"

namespace delcert {

/// The dual basis w_1 … w_k of the edges p_j − p_0 of a simplex, that is, the rows of the pseudo-inverse of P, and w_0,
/// minus their sum; exactly, in integers over common denominators: fractions would be reduced after each operation.
class DualBasis {
 public:
  /// Nothing if the simplex is degenerate. Precondition: some simplex has these edges.
  [[nodiscard]] static std::optional<DualBasis> of(const EdgeGram<Rational>& simplex);

  [[nodiscard]] std::size_t dimension() const { return adjugate_.size(); }

  /// ⟨w_i, p_j − p_0⟩ in row i = 0 … k and column j − 1 = 0 … k − 1: of the w_i in coordinates, which are combinations
  /// of the edges, with the edges. Precondition: these are the vertices of the simplex.
  [[nodiscard]] std::vector<std::vector<Rational>> products(const std::vector<std::vector<Rational>>& points) const;
  /// The same from the inner products of the edges.
  [[nodiscard]] std::vector<std::vector<Rational>> products() const;

  /// D(p_i, σ)²‖w_i‖² for i = 0 … k, the altitude from the opposite facet by elimination, the length from the inverse
  /// of the Gram matrix.
  [[nodiscard]] Rational squared_altitude_times_length(std::size_t i) const;

  /// Υ(σ)², the least altitude being the inverse of the greatest length.
  [[nodiscard]] Rational squared_thickness() const;
  /// R(σ)².
  [[nodiscard]] Rational squared_circumradius() const;

 private:
  using Integers = std::vector<std::vector<Integer>>;
  DualBasis() = default;
  [[nodiscard]] Integer product(std::size_t base, std::size_t i, std::size_t j) const;
  [[nodiscard]] Integer squared_length(std::size_t i) const;
  [[nodiscard]] std::vector<std::vector<Rational>> with_row_of_first(const Integers& products,
                                                                     const Integer& multiplier,
                                                                     const Integer& divisor) const;

  Integer unit_ = 2;        ///< twice a common denominator of the squared edges
  Integers squared_edges_;  ///< times half the unit
  Integers adjugate_;       ///< of the Gram matrix times the unit
  Integer determinant_;     ///< of the same
};

}  // namespace delcert
