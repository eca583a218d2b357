#pragma once

#include "kernel/chart/model_space.hpp"
#include "kernel/manifold/quotient/invariant_form.hpp"

namespace delcert {

/// F_j⁻¹ γ F_i in the standard basis, enclosed at the working precision: what carries a point from the chart of i to
/// that of j through the group element γ. Charts are centred at points with exact conformal coordinates (on a flat
/// manifold: coordinates of the frame). Precondition: m is the dimension of the form, and γ preserves it.
template <int m>
[[nodiscard]] ModelMatrix<BigInterval, m> transition_matrix(const InvariantForm& form, const FieldMatrix& element,
                                                            const Vector<Rational, m>& home,
                                                            const Vector<Rational, m>& seen_from) {
  const auto enclosed = [](const ModelMatrix<Rational, m>& exact) {
    ModelMatrix<BigInterval, m> result;
    for (std::size_t row = 0; row <= m; ++row) {
      for (std::size_t column = 0; column <= m; ++column) result[row][column] = BigInterval(exact[row][column]);
    }
    return result;
  };
  const auto rows = form.in_standard_basis(element);
  ModelMatrix<BigInterval, m> middle;
  for (std::size_t row = 0; row <= m; ++row) {
    for (std::size_t column = 0; column <= m; ++column) middle[row][column] = rows[row][column];
  }
  const auto frame = enclosed(model_frame<Rational, m>(form.curvature(), home));
  const auto back = enclosed(inverse_model_frame<Rational, m>(form.curvature(), seen_from));
  return product(back, product(middle, frame));
}

/// The same in doubles, outwards.
template <int m>
[[nodiscard]] ModelMatrix<Interval, m> in_doubles(const ModelMatrix<BigInterval, m>& matrix) {
  ModelMatrix<Interval, m> result;
  for (std::size_t row = 0; row <= m; ++row) {
    for (std::size_t column = 0; column <= m; ++column) result[row][column] = in_doubles(matrix[row][column]);
  }
  return result;
}

/// exp_j⁻¹ ∘ γ ∘ exp_i of a tangent vector at i: exp_o⁻¹ (M exp_o v). Precondition for S = Interval: a `RoundingGuard`
/// is alive. Unbounded where the image may be the antipode of j.
template <class S, int m>
[[nodiscard]] Vector<S, m> carried(Curvature curvature, const ModelMatrix<S, m>& matrix, const Vector<S, m>& v) {
  return logarithm<S, m>(curvature, applied(matrix, exponential<S, m>(curvature, v)));
}

}  // namespace delcert
