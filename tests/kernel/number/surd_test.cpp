#include "kernel/number/surd.hpp"

#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

#include "kernel/number/algebraic.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(Scalar<Surd>);
static_assert(!std::is_constructible_v<Surd, double>);

/// A number as a surd and as an algebraic number.
struct Both {
  Surd surd;
  Algebraic algebraic;
};

/// factor·√radicand for many small factors and radicands, squares and multiples of squares among them.
std::vector<Both> small_numbers() {
  const Rational half = Rational(1) / Rational(2);
  std::vector<Both> result;
  for (const Rational& factor : {Rational(-2), Rational(-1), Rational(0), half, Rational(1), Rational(3)}) {
    for (const Rational& radicand : {half, Rational(1), Rational(2), Rational(3), Rational(4), Rational(8)}) {
      result.push_back(
          {Surd(factor) * square_root(Surd(radicand)), Algebraic(factor) * square_root(Algebraic(radicand))});
    }
  }
  return result;
}

void expect_equal(const Surd& surd, const Algebraic& algebraic, const char* operation) {
  ASSERT_TRUE(surd.is_known()) << operation;
  // The square and the sign tell a surd.
  const auto squared = square(surd).rational();
  ASSERT_TRUE(squared.has_value()) << operation;
  EXPECT_EQ(is_zero(Algebraic(*squared) - square(algebraic)), Verdict::proved) << operation;
  EXPECT_EQ(less(surd, Surd(0)), less(algebraic, Algebraic(0))) << operation;
}

/// Whether the sum of two is again a surd.
bool is_commensurable(const Both& a, const Both& b) {
  return is_proved(is_zero(a.algebraic)) || is_proved(is_zero(b.algebraic)) ||
         (a.algebraic / b.algebraic).degree() == 1;
}

TEST(Surd, agrees_with_algebraic_numbers_on_all_pairs_of_small_ones) {
  const auto numbers = small_numbers();
  for (const Both& a : numbers) {
    expect_equal(-a.surd, -a.algebraic, "negation");
    expect_equal(absolute(a.surd), absolute(a.algebraic), "absolute value");
    expect_equal(square(a.surd), square(a.algebraic), "square");
    EXPECT_EQ(is_zero(a.surd), is_zero(a.algebraic));
    for (const Both& b : numbers) {
      EXPECT_EQ(less(a.surd, b.surd), less(a.algebraic, b.algebraic));
      EXPECT_EQ(less_equal(a.surd, b.surd), less_equal(a.algebraic, b.algebraic));
      expect_equal(minimum(a.surd, b.surd), minimum(a.algebraic, b.algebraic), "minimum");
      expect_equal(maximum(a.surd, b.surd), maximum(a.algebraic, b.algebraic), "maximum");
      expect_equal(a.surd * b.surd, a.algebraic * b.algebraic, "product");
      if (is_proved(is_zero(b.algebraic))) {
        EXPECT_FALSE((a.surd / b.surd).is_known());
      } else {
        expect_equal(a.surd / b.surd, a.algebraic / b.algebraic, "quotient");
      }
      if (is_commensurable(a, b)) {
        expect_equal(a.surd + b.surd, a.algebraic + b.algebraic, "sum");
        expect_equal(a.surd - b.surd, a.algebraic - b.algebraic, "difference");
      } else {
        EXPECT_FALSE((a.surd + b.surd).is_known());
        EXPECT_FALSE((a.surd - b.surd).is_known());
      }
    }
  }
}

TEST(Surd, roots_exist_for_rational_numbers_that_are_not_negative) {
  EXPECT_TRUE(square_root(Surd(0)).rational() == Rational(0));
  EXPECT_TRUE(square_root(Surd(Rational(9) / Rational(4))).rational() == Rational(3) / Rational(2));
  EXPECT_FALSE(square_root(Surd(2)).rational().has_value());
  EXPECT_TRUE(square_root(Surd(2)).is_known());
  EXPECT_FALSE(square_root(Surd(-1)).is_known());
  EXPECT_FALSE(square_root(square_root(Surd(2))).is_known());
}

TEST(Surd, a_product_of_roots_that_is_rational_is_found_to_be) {
  const Surd product = square_root(Surd(2)) * square_root(Surd(8));
  EXPECT_TRUE(product.rational() == Rational(4));
  EXPECT_TRUE(square_root(product).rational() == Rational(2));
  EXPECT_FALSE((square_root(Surd(2)) * square_root(Surd(6))).rational().has_value());
}

TEST(Surd, what_is_unknown_spreads_and_decides_nothing) {
  const Surd unknown = Surd::unknown();
  const Surd two(2);
  for (const Surd& result : {unknown + two, two + unknown, unknown - two, two - unknown, unknown * two, two * unknown,
                             Surd(0) * unknown, unknown / two, two / unknown, -unknown, square(unknown),
                             square_root(unknown), absolute(unknown), minimum(unknown, two), maximum(two, unknown)}) {
    EXPECT_FALSE(result.is_known());
    EXPECT_FALSE(result.rational().has_value());
  }
  for (const Verdict verdict : {less(unknown, two), less(two, unknown), less_equal(unknown, two),
                                less_equal(two, unknown), less(unknown, unknown), is_zero(unknown)}) {
    EXPECT_EQ(verdict, Verdict::undecided);
  }
}

TEST(Surd, neighbours_of_a_tie_are_told_apart) {
  const Surd root = square_root(Surd(2)) * square_root(Surd(3));
  EXPECT_EQ(less_equal(root, square_root(Surd(6))), Verdict::proved);
  EXPECT_EQ(less(root, square_root(Surd(6))), Verdict::refuted);
  const Surd above = square_root(Surd(Rational(6) + Rational::power_of_two(-5000)));
  EXPECT_EQ(less(root, above), Verdict::proved);
  EXPECT_EQ(less(-above, -root), Verdict::proved);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
