#include "kernel/simplex/matrix_norm.hpp"

#include "kernel/number/ladder.hpp"
#include "kernel/simplex/inertia.hpp"

namespace delcert {

namespace {

/// Whether the largest eigenvalue is at least the bound: some eigenvalue of the shifted matrix is not negative.
bool has_eigenvalue_at_least(const SymmetricMatrix<Rational>& matrix, const Rational& bound) {
  const SymmetricMatrix<Rational> shifted = matrix.shifted(-bound);
  return is_proved(decide([&]<class S>() {
    const auto signs = inertia(matrix_from<S>(shifted));
    return signs ? verdict_of(signs->positive + signs->zero > 0) : Verdict::undecided;
  }));
}

Rational squared_frobenius_norm(const SymmetricMatrix<Rational>& matrix) {
  Rational result(0);
  for (std::size_t row = 0; row < matrix.order(); ++row) {
    for (std::size_t column = 0; column < matrix.order(); ++column) result += square(matrix(row, column));
  }
  return result;
}

/// A power of two that is at least √x, for x > 0.
Rational root_bound(const Rational& x) { return Rational::power_of_two(binary_exponent(x) / 2 + 1); }

}  // namespace

RationalBounds symmetric_norm_bounds(const SymmetricMatrix<Rational>& matrix, unsigned bits) {
  const Rational frobenius = squared_frobenius_norm(matrix);
  if (is_proved(is_zero(frobenius))) return {Rational(0), Rational(0)};
  const SymmetricMatrix<Rational> negated = matrix.negated();
  return bisected(root_bound(frobenius), bits, [&](const Rational& bound) {
    return has_eigenvalue_at_least(matrix, bound) || has_eigenvalue_at_least(negated, bound);
  });
}

RationalBounds norm_bounds(std::span<const std::vector<Rational>> columns, unsigned bits) {
  const SymmetricMatrix<Rational> gram = gram_of_columns(columns);
  Rational trace(0);
  for (std::size_t i = 0; i < gram.order(); ++i) trace += gram(i, i);
  if (is_proved(is_zero(trace))) return {Rational(0), Rational(0)};
  return bisected(root_bound(trace), bits,
                  [&](const Rational& bound) { return has_eigenvalue_at_least(gram, square(bound)); });
}

}  // namespace delcert
