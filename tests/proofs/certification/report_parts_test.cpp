#include "proofs/certification/report_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "kernel/number/exact_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// The number that "-1.235e+00" is.
Rational read_back(const std::string& text) {
  const std::size_t exponent = text.find('e');
  std::string digits = text.substr(0, exponent);
  const std::size_t point = digits.find('.');
  long shift = std::stol(text.substr(exponent + 1));
  if (point != std::string::npos) {
    shift -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  return Rational(std::stol(digits)) * power(Rational(10), shift);
}

std::vector<Rational> numbers() {
  std::vector<Rational> result{Rational(0)};
  for (const long mantissa : {1L, 9999L, 10000L, 12345L, 99995L, 99999L, 123456789L}) {
    for (const long exponent : {-40L, -3L, 0L, 5L, 40L}) {
      const Rational x = Rational(mantissa) * power(Rational(10), exponent);
      for (const long nudge : {-60L, -30L, 0L}) {
        const Rational near = nudge == 0 ? Rational(0) : x * Rational::power_of_two(nudge);
        for (const Rational& y : {Rational(x - near), Rational(x + near)}) {
          result.push_back(y);
          result.push_back(-y);
        }
      }
    }
  }
  return result;
}

TEST(ReportParts, printed_bounds_are_on_the_safe_side_when_they_are_read_back) {
  for (const Rational& x : numbers()) {
    const Rational lower = read_back(decimal_lower(x));
    const Rational upper = read_back(decimal_upper(x));
    EXPECT_LE(lower, x) << decimal_lower(x);
    EXPECT_GE(upper, x) << decimal_upper(x);
    // No looser than four digits are.
    EXPECT_LE(upper - lower, absolute(x) / Rational(1000));
  }
}

TEST(ReportParts, what_has_four_digits_is_printed_as_it_is) {
  for (const long mantissa : {1000L, 1001L, 1234L, 9999L, -1000L, -1234L, -9999L}) {
    const Rational x = Rational(mantissa) / Rational(1000);
    EXPECT_EQ(read_back(decimal_lower(x)), x);
    EXPECT_EQ(read_back(decimal_upper(x)), x);
  }
  EXPECT_EQ(decimal_lower(Rational(-12341) / Rational(10000)), "-1.235e+00");
  EXPECT_EQ(decimal_upper(Rational(-12341) / Rational(10000)), "-1.234e+00");
  EXPECT_EQ(decimal_lower(Rational(0)), "0.000e+00");
}

TEST(ReportParts, bounds_are_on_the_safe_side_as_doubles_too) {
  const Rational epsilon = Rational(1) / Rational(7);
  for (const Rational& x : numbers()) {
    for (const auto unit : {Margin::Unit::one, Margin::Unit::length, Margin::Unit::squared_length}) {
      const auto lower = lower_json(x, unit, epsilon);
      const auto upper = upper_json(x, unit, epsilon);
      EXPECT_EQ(parse_exact(lower["exact"].get<std::string>()), x);
      EXPECT_EQ(lower["bound"], "lower");
      EXPECT_EQ(upper["bound"], "upper");
      EXPECT_LE(Rational::exactly(lower["value"].get<double>()), x);
      EXPECT_GE(Rational::exactly(upper["value"].get<double>()), x);
      EXPECT_LE(upper["value"].get<double>() - lower["value"].get<double>(),
                0x1p-51 * std::abs(upper["value"].get<double>()));
      EXPECT_EQ(lower.contains("in_sampling_radii"), unit != Margin::Unit::one);
      if (unit == Margin::Unit::one) continue;
      const Rational relative = x * Rational(unit == Margin::Unit::length ? 7 : 49);
      EXPECT_LE(Rational::exactly(lower["in_sampling_radii"].get<double>()), relative);
      EXPECT_GE(Rational::exactly(upper["in_sampling_radii"].get<double>()), relative);
    }
  }
  EXPECT_EQ(upper_json(Rational(1))["unit"], "1");
  EXPECT_EQ(upper_json(Rational(1), Margin::Unit::length, epsilon)["unit"], "length");
  EXPECT_EQ(upper_json(Rational(1), Margin::Unit::squared_length, epsilon)["unit"], "length^2");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
