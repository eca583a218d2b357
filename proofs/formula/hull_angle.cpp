#include "proofs/formula/hull_angle.hpp"

#include "kernel/simplex/gram_elimination.hpp"

namespace delcert {

namespace {

/// Whether tG − A is positive semidefinite.
bool is_squared_sine_at_most(const SymmetricMatrix<Rational>& across, const SymmetricMatrix<Rational>& gram,
                             const Rational& t) {
  SymmetricMatrix<Rational> rest(gram.order());
  for (std::size_t i = 0; i < gram.order(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) rest(i, j) = t * gram(i, j) - across(i, j);
  }
  return is_proved(GramElimination<Rational>(rest).semidefinite());
}

}  // namespace

Partial<RationalBounds> greatest_squared_sine(const SymmetricMatrix<Rational>& across,
                                              const SymmetricMatrix<Rational>& gram, unsigned bits) {
  if (gram.order() == 0 || !is_proved(GramElimination<Rational>(gram).definite())) {
    return Partial<RationalBounds>::absent(Verdict::refuted);
  }
  if (gram.order() == 1) {
    const Rational value = across(0, 0) / gram(0, 0);
    return RationalBounds{value, value};
  }
  RationalBounds result{Rational(0), Rational(1)};
  if (is_squared_sine_at_most(across, gram, result.lower)) return RationalBounds{result.lower, result.lower};
  // A line at a right angle: the difference G − A is singular.
  SymmetricMatrix<Rational> along(gram.order());
  for (std::size_t i = 0; i < gram.order(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) along(i, j) = gram(i, j) - across(i, j);
  }
  if (!is_proved(GramElimination<Rational>(along).definite())) return RationalBounds{result.upper, result.upper};
  const Rational narrow = Rational::power_of_two(-static_cast<long>(bits));
  while (result.upper - result.lower > narrow) {
    const Rational middle = (result.lower + result.upper) / Rational(2);
    (is_squared_sine_at_most(across, gram, middle) ? result.upper : result.lower) = middle;
  }
  return result;
}

}  // namespace delcert
