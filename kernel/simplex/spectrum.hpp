#pragma once

#include <cstddef>
#include <vector>

#include "kernel/number/algebraic.hpp"
#include "kernel/number/surd.hpp"
#include "kernel/simplex/partial.hpp"
#include "kernel/simplex/symmetric_matrix.hpp"

namespace delcert {

// Eigenvalues of an exactly known symmetric matrix on the rungs that have roots. Singular values of P are roots of
// those of PᵀP, the norm of a symmetric matrix is the larger size of the first and the last.

/// All eigenvalues, the largest first, each as often as its multiplicity. There is no generic way, hence no primary
/// definition.
template <class S>
[[nodiscard]] Partial<std::vector<S>> eigenvalues(const SymmetricMatrix<Rational>& matrix) = delete;

/// Approximations are found in doubles, widened until the inertia on intervals proves them; absent (undecided) where
/// it does not. Intervals are at most 2⁻³⁰ of the largest size of an eigenvalue wide. Needs a `RoundingGuard`.
template <>
[[nodiscard]] Partial<std::vector<Interval>> eigenvalues<Interval>(const SymmetricMatrix<Rational>& matrix);
/// Roots of the characteristic polynomial to the working precision, where they nearly coincide to that of the largest.
/// Always there.
template <>
[[nodiscard]] Partial<std::vector<BigInterval>> eigenvalues<BigInterval>(const SymmetricMatrix<Rational>& matrix);
/// For a matrix of order 1 at most; otherwise absent (undecided).
template <>
[[nodiscard]] Partial<std::vector<Surd>> eigenvalues<Surd>(const SymmetricMatrix<Rational>& matrix);
/// Roots of the characteristic polynomial. Always there.
template <>
[[nodiscard]] Partial<std::vector<Algebraic>> eigenvalues<Algebraic>(const SymmetricMatrix<Rational>& matrix);

/// The eigenvalue of one index, 0 for the largest; as `eigenvalues`, where one costs as much as all.
template <class S>
[[nodiscard]] Partial<S> eigenvalue(const SymmetricMatrix<Rational>& matrix, std::size_t index) {
  const auto all = eigenvalues<S>(matrix);
  return all ? Partial<S>((*all)[index]) : Partial<S>::absent(all.exists());
}
template <>
[[nodiscard]] Partial<Interval> eigenvalue<Interval>(const SymmetricMatrix<Rational>& matrix, std::size_t index);

/// The eigenvalues of a matrix, found for a multiple of it with entries of about 1: the search for the roots of a
/// polynomial begins there, and would take seconds to come to 2⁻³⁰⁰.
template <class S>
[[nodiscard]] Partial<std::vector<S>> eigenvalues_by_scaling(SymmetricMatrix<Rational> matrix) {
  Rational greatest(0);
  for (std::size_t i = 0; i < matrix.order(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) greatest = maximum(greatest, absolute(matrix(i, j)));
  }
  if (greatest == Rational(0)) return std::vector<S>(matrix.order(), S(0));
  const long exponent = binary_exponent(greatest);
  const Rational unit = Rational::power_of_two(-exponent);
  for (std::size_t i = 0; i < matrix.order(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) matrix(i, j) *= unit;
  }
  auto result = eigenvalues<S>(matrix);
  if (!result) return result;
  const S back = scalar_from<S>(Rational::power_of_two(exponent));
  for (S& value : *result) value = value * back;
  return result;
}

/// The coefficients of det(xI − A), that of x⁰ first.
[[nodiscard]] std::vector<Rational> characteristic_polynomial(const SymmetricMatrix<Rational>& matrix);

/// ‖A‖ for a symmetric matrix with these eigenvalues, the largest first; 0 if there are none.
template <class S>
[[nodiscard]] S norm_from_eigenvalues(const std::vector<S>& eigenvalues) {
  if (eigenvalues.empty()) return S(0);
  return maximum(absolute(eigenvalues.front()), absolute(eigenvalues.back()));
}

}  // namespace delcert
