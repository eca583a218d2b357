#include "kernel/simplex/singular_values.hpp"

#include <stdexcept>

#include "kernel/number/ladder.hpp"

namespace delcert {

namespace {

bool is_at_least(const SymmetricMatrix<Rational>& gram, std::size_t index, const Rational& bound) {
  const SymmetricMatrix<Rational> shifted = gram.shifted(-square(bound));
  return is_proved(decide([&]<class S>() {
    const auto signs = inertia(matrix_from<S>(shifted));
    return signs ? verdict_of(signs->positive + signs->zero >= index) : Verdict::undecided;
  }));
}

}  // namespace

RationalBounds singular_value_bounds(const EdgeGram<Rational>& simplex, std::size_t index, unsigned bits) {
  const SymmetricMatrix<Rational>& gram = simplex.gram();
  if (index < 1 || index > gram.order()) throw std::invalid_argument("no singular value of this index");
  if (inertia(gram)->positive < index) return {Rational(0), Rational(0)};

  Rational squared_norm_bound(0);  // the trace
  for (std::size_t i = 0; i < gram.order(); ++i) squared_norm_bound += gram(i, i);
  return bisected(Rational::power_of_two(binary_exponent(squared_norm_bound) / 2 + 1), bits,
                  [&](const Rational& bound) { return is_at_least(gram, index, bound); });
}

}  // namespace delcert
