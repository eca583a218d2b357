#include "kernel/number/algebraic.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "tests/kernel/number/random_numbers.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(Scalar<Algebraic>);
static_assert(std::is_nothrow_move_constructible_v<Algebraic>);

Algebraic root_of(int integer) { return square_root(Algebraic(integer)); }

bool equal(const Algebraic& a, const Algebraic& b) { return is_proved(is_zero(a - b)); }

// CORE::Expr in g++ builds of CGAL 5.5.1 says that this is negative.
TEST(Algebraic, a_unit_vector_has_length_one_even_where_core_errs) {
  const std::array<Rational, 3> p = {Rational::exactly(-0x1.cf1ae569ccd57p-1), Rational::exactly(0x1.b4a93e9b1b069p-2),
                                     Rational::exactly(0x1.89e0b786c7c76p-8)};
  const Algebraic length = square_root(Algebraic(square(p[0]) + square(p[1]) + square(p[2])));
  EXPECT_EQ(length.degree(), 2);
  Algebraic excess(-1);
  for (const Rational& coordinate : p) excess += square(Algebraic(coordinate) / length);
  EXPECT_EQ(is_zero(excess), Verdict::proved);
  EXPECT_EQ(less(excess, Algebraic(0)), Verdict::refuted);
  EXPECT_EQ(less(Algebraic(0), excess), Verdict::refuted);
  // The twin: one unit in the last place of one coordinate away from it.
  Algebraic other(-1);
  for (const Rational& coordinate : {p[0], p[1], p[2] + Rational::power_of_two(-60)})
    other += square(Algebraic(coordinate) / length);
  EXPECT_EQ(is_zero(other), Verdict::refuted);
  EXPECT_EQ(less(Algebraic(0), other), Verdict::proved);
}

TEST(Algebraic, agrees_with_rationals_where_both_apply) {
  RandomNumbers random(11);
  for (int round = 0; round < 2000; ++round) {
    const Rational x = Rational::exactly(random.hard_double());
    const Rational y = Rational::exactly(random.hard_double());
    const Algebraic a(x);
    const Algebraic b(y);
    ASSERT_TRUE((a + b).rational() == x + y);
    ASSERT_TRUE((a - b).rational() == x - y);
    ASSERT_TRUE((a * b).rational() == x * y);
    if (y != Rational(0)) {
      ASSERT_TRUE((a / b).rational() == x / y);
    }
    ASSERT_TRUE((-a).rational() == -x);
    ASSERT_TRUE(square(a).rational() == square(x));
    ASSERT_TRUE(absolute(a).rational() == absolute(x));
    ASSERT_TRUE(minimum(a, b).rational() == minimum(x, y));
    ASSERT_TRUE(maximum(a, b).rational() == maximum(x, y));
    ASSERT_TRUE(square_root(square(a)).rational() == absolute(x));
    ASSERT_EQ(less(a, b), less(x, y));
    ASSERT_EQ(less_equal(a, b), less_equal(x, y));
    ASSERT_EQ(is_zero(a), is_zero(x));
    ASSERT_TRUE(scalar_from<Algebraic>(x).rational() == x);
  }
}

TEST(Algebraic, roots_satisfy_their_equations_and_identities) {
  EXPECT_TRUE(equal(square(root_of(2)), Algebraic(2)));
  EXPECT_TRUE(equal(root_of(2) * root_of(3), root_of(6)));
  EXPECT_TRUE(equal(root_of(8), Algebraic(2) * root_of(2)));
  EXPECT_TRUE(equal(square_root(Algebraic(3) + Algebraic(2) * root_of(2)), Algebraic(1) + root_of(2)));
  EXPECT_TRUE(equal(square_root(Algebraic(5) + Algebraic(2) * root_of(6)), root_of(2) + root_of(3)));
  EXPECT_TRUE(equal(Algebraic(1) / (root_of(3) - root_of(2)), root_of(3) + root_of(2)));
  EXPECT_TRUE(equal(absolute(Algebraic(1) - root_of(2)), root_of(2) - Algebraic(1)));
  EXPECT_EQ(root_of(0).degree(), 1);
  EXPECT_TRUE(equal(root_of(49), Algebraic(7)));
}

TEST(Algebraic, order_is_decided_for_neighbours_and_equals) {
  EXPECT_EQ(less(root_of(2) + root_of(3), root_of(10)), Verdict::proved);
  EXPECT_EQ(less(root_of(10), root_of(2) + root_of(3)), Verdict::refuted);
  EXPECT_EQ(less_equal(root_of(6), root_of(2) * root_of(3)), Verdict::proved);
  EXPECT_EQ(less(root_of(6), root_of(2) * root_of(3)), Verdict::refuted);
  for (int k = 8; k <= 4096; k *= 2) {
    const Algebraic moved = root_of(2) + Algebraic(Rational::power_of_two(-k));
    EXPECT_EQ(less(root_of(2), moved), Verdict::proved) << k;
    EXPECT_EQ(less(moved, root_of(2)), Verdict::refuted) << k;
    EXPECT_EQ(is_zero(moved - root_of(2)), Verdict::refuted) << k;
  }
  EXPECT_TRUE(equal(minimum(root_of(2), root_of(3)), root_of(2)));
  EXPECT_TRUE(equal(maximum(root_of(2), root_of(3)), root_of(3)));
}

TEST(Algebraic, enclosures_contain_the_number_at_every_precision) {
  for (const unsigned bits : {16U, 128U, 1024U}) {
    const BigInterval::Precision precision(PrecisionBits{bits});
    const BigInterval root = root_of(2).enclosure();
    EXPECT_TRUE(square(root.lower()) < Rational(2) && Rational(2) < square(root.upper())) << bits;
    EXPECT_TRUE(root.upper() - root.lower() < Rational::power_of_two(4 - static_cast<long>(bits))) << bits;
    const BigInterval negative = (-root_of(2)).enclosure();
    EXPECT_TRUE(negative.lower() < negative.upper() && negative.upper() < Rational(0)) << bits;
    const BigInterval third = Algebraic(Rational(1) / Rational(3)).enclosure();
    EXPECT_TRUE(third.lower() < Rational(1) / Rational(3) && Rational(1) / Rational(3) < third.upper()) << bits;
  }
}

TEST(Algebraic, division_by_zero_and_roots_of_negative_numbers_throw) {
  EXPECT_THROW(static_cast<void>(Algebraic(1) / (root_of(6) - root_of(2) * root_of(3))), std::domain_error);
  EXPECT_THROW(static_cast<void>(square_root(root_of(2) - root_of(3))), std::domain_error);
  EXPECT_NO_THROW(static_cast<void>(square_root(root_of(6) - root_of(2) * root_of(3))));
  EXPECT_THROW(static_cast<void>(root_of(2).rational()), std::domain_error);
}

TEST(Algebraic, a_degree_beyond_the_limit_is_refused_and_not_waited_for) {
  Algebraic sum(0);
  for (const int prime : {2, 3, 5, 7, 11, 13, 17}) sum += root_of(prime);
  EXPECT_EQ(sum.degree(), Algebraic::greatest_degree);
  EXPECT_THROW(sum += root_of(19), Algebraic::TooLarge);
  EXPECT_THROW(static_cast<void>(square_root(sum)), Algebraic::TooLarge);
  EXPECT_EQ(less(Algebraic(19), sum), Verdict::proved);
}

TEST(Algebraic, copies_are_independent_and_assignment_to_itself_and_after_moving_works) {
  Algebraic a = root_of(2);
  Algebraic b = a;
  b += Algebraic(1);
  EXPECT_TRUE(equal(a, root_of(2)));
  EXPECT_TRUE(equal(b - a, Algebraic(1)));
  const Algebraic& alias = a;
  a = alias;
  EXPECT_TRUE(equal(a, root_of(2)));
  const Algebraic c = std::move(a);
  a = b;
  EXPECT_TRUE(equal(c + Algebraic(1), a));
  a -= alias;
  EXPECT_EQ(is_zero(a), Verdict::proved);
  b *= b;
  b /= root_of(2);
  EXPECT_TRUE(equal(b, Algebraic(2) + Algebraic(3) / root_of(2)));
}

TEST(Algebraic, real_roots_come_in_order_with_their_multiplicity_and_without_the_complex_ones) {
  // (x − 1)² (x + 2) (x² + 1) x
  const std::vector<Rational> coefficients = {0, 2, -3, 2, -2, 0, 1};
  const auto roots = real_roots(coefficients);
  ASSERT_EQ(roots.size(), 4U);
  const std::vector<int> expected = {-2, 0, 1, 1};
  for (std::size_t at = 0; at < roots.size(); ++at) EXPECT_TRUE(equal(roots[at], Algebraic(expected[at]))) << at;
}

TEST(Algebraic, real_roots_are_roots_and_all_of_them) {
  // x³ − 3x + 1 has three, x³ − 2 one, x⁴ + 1 none.
  const std::vector<Rational> three = {1, -3, 0, 1};
  const auto roots = real_roots(three);
  ASSERT_EQ(roots.size(), 3U);
  for (const Algebraic& root : roots) {
    EXPECT_EQ(is_zero(square(root) * root - Algebraic(3) * root + Algebraic(1)), Verdict::proved);
  }
  EXPECT_EQ(less(roots[0], roots[1]), Verdict::proved);
  EXPECT_EQ(less(roots[1], roots[2]), Verdict::proved);
  const std::vector<Rational> one = {-2, 0, 0, 1};
  ASSERT_EQ(real_roots(one).size(), 1U);
  EXPECT_TRUE(equal(square(real_roots(one)[0]) * real_roots(one)[0], Algebraic(2)));
  const std::vector<Rational> none = {1, 0, 0, 0, 1};
  EXPECT_TRUE(real_roots(none).empty());
}

TEST(Algebraic, real_roots_of_rational_coefficients_leading_zeros_and_constants) {
  const std::vector<Rational> rational = {Rational(-1) / Rational(9), 0, 1, 0, 0};
  const auto roots = real_roots(rational);
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_TRUE(roots[0].rational() == Rational(-1) / Rational(3));
  EXPECT_TRUE(roots[1].rational() == Rational(1) / Rational(3));
  const std::vector<Rational> constant = {5};
  EXPECT_TRUE(real_roots(constant).empty());
  const std::vector<Rational> zero = {0, 0};
  EXPECT_THROW((void)real_roots(zero), std::invalid_argument);
  EXPECT_THROW((void)real_roots(std::vector<Rational>{}), std::invalid_argument);
}

// Two roots that no double tells apart.
TEST(Algebraic, real_roots_that_nearly_coincide_are_two) {
  const Rational gap = Rational::power_of_two(-300);
  const std::vector<Rational> coefficients = {Rational(1) + gap, -(Rational(2) + gap), 1};
  const auto roots = real_roots(coefficients);
  ASSERT_EQ(roots.size(), 2U);
  EXPECT_TRUE(roots[0].rational() == Rational(1));
  EXPECT_TRUE(roots[1].rational() == Rational(1) + gap);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
