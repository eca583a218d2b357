#include "kernel/manifold/submanifold/dense.hpp"

#include <gtest/gtest.h>

#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(InverseOf, is_exact_on_rationals) {
  // A pivot is 0 at first.
  const Dense<Rational> a{Rational(0), Rational(2), Rational(1), ratio(1, 3), Rational(1),
                          Rational(0), Rational(4), Rational(0), Rational(5)};
  const auto inverse = inverse_of(a, 3).value();
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      Rational sum(0);
      for (std::size_t k = 0; k < 3; ++k) sum += a[row * 3 + k] * inverse[k * 3 + column];
      EXPECT_EQ(sum, Rational(row == column ? 1 : 0));
    }
  }
}

TEST(InverseOf, is_none_of_singular_matrices) {
  EXPECT_FALSE(inverse_of(Dense<Rational>{Rational(1), Rational(2), Rational(2), Rational(4)}, 2));
  EXPECT_FALSE(inverse_of(Dense<double>{1, 2, 2, 4}, 2));
  const auto inverse = inverse_of(Dense<double>{0, 2, 1, 0}, 2).value();
  EXPECT_EQ(inverse, (Dense<double>{0, 1, 0.5, 0}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
