#include "kernel/number/decimal_bounds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <string>

namespace delcert {
namespace DELCERT_THIS_FILE {

/// Reads what the functions print, exactly.
Rational value_of(const std::string& text) {
  const auto exponent_at = text.find('e');
  std::string mantissa = text.substr(0, exponent_at);
  long exponent = exponent_at == std::string::npos ? 0 : std::stol(text.substr(exponent_at + 1));
  const auto point = mantissa.find('.');
  if (point != std::string::npos) {
    exponent -= static_cast<long>(mantissa.size() - point - 1);
    mantissa.erase(point, 1);
  }
  const bool negative = mantissa.front() == '-';
  if (negative) mantissa.erase(0, 1);
  mantissa.erase(0, std::min(mantissa.find_first_not_of('0'), mantissa.size() - 1));
  const Rational size = Rational(Integer(mantissa)) * power(Rational(10), exponent);
  return negative ? -size : size;
}

TEST(DecimalBounds, are_exact_where_digits_suffice) {
  for (const auto& bound : {decimal_lower, decimal_upper}) {
    EXPECT_EQ(bound(Rational(0), 4), "0");
    EXPECT_EQ(bound(Rational(1), 4), "1");
    EXPECT_EQ(bound(Rational(1) / Rational(4), 4), "0.25");
    EXPECT_EQ(bound(Rational(-5) / Rational(2), 4), "-2.5");
    EXPECT_EQ(bound(Rational(1230), 4), "1230");
    EXPECT_EQ(bound(Rational(12300), 4), "1.23e4");
    EXPECT_EQ(bound(Rational(1) / Rational(1000), 4), "0.001");
    EXPECT_EQ(bound(Rational(1) / Rational(100000), 4), "1e-5");
  }
}

TEST(DecimalBounds, are_rounded_outwards) {
  EXPECT_EQ(decimal_lower(Rational(1) / Rational(3), 4), "0.3333");
  EXPECT_EQ(decimal_upper(Rational(1) / Rational(3), 4), "0.3334");
  EXPECT_EQ(decimal_lower(Rational(-1) / Rational(3), 4), "-0.3334");
  EXPECT_EQ(decimal_upper(Rational(-1) / Rational(3), 4), "-0.3333");
}

TEST(DecimalBounds, carry_into_a_new_digit) {
  EXPECT_EQ(decimal_upper(Rational(99999) / Rational(100000), 3), "1");
  EXPECT_EQ(decimal_upper(Rational(99999), 3), "1e5");
  EXPECT_EQ(decimal_lower(Rational(99999), 3), "9.99e4");
}

TEST(DecimalBounds, reach_beyond_doubles) {
  const Rational tiny = Rational::power_of_two(-2095);
  EXPECT_LE(value_of(decimal_lower(tiny, 6)), tiny);
  EXPECT_GE(value_of(decimal_upper(tiny, 6)), tiny);
  EXPECT_EQ(decimal_lower(tiny, 3).substr(4), "e-631");
}

RC_GTEST_PROP(DecimalBounds, enclose_the_number_within_a_unit_of_the_last_digit, ()) {
  const auto numerator = *rc::gen::inRange<long>(-1000000000, 1000000000);
  const auto denominator = *rc::gen::inRange<long>(1, 1000000000);
  const auto shift = *rc::gen::inRange<long>(-40, 40);
  const auto digits = *rc::gen::inRange<int>(1, 9);
  const Rational x = Rational(numerator) / Rational(denominator) * Rational::power_of_two(shift);
  const Rational lower = value_of(decimal_lower(x, digits));
  const Rational upper = value_of(decimal_upper(x, digits));
  RC_ASSERT(lower <= x);
  RC_ASSERT(x <= upper);
  RC_ASSERT((upper - lower) * power(Rational(10), digits - 1) <= absolute(x));
  RC_ASSERT((lower == x) == (upper == x));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
