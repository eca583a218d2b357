#include "proofs/checker/exact_number.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/checker/support/exact_double.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using checker::exact_value;
using checker::is_exact_number;
using checker::Rational;

TEST(ExactNumber, has_the_value_of_its_text) {
  EXPECT_EQ(exact_value("0"), Rational(0));
  EXPECT_EQ(exact_value("-007"), Rational(-7));
  EXPECT_EQ(exact_value("6/4"), Rational(3) / Rational(2));
  EXPECT_EQ(exact_value("-0/5"), Rational(0));
  EXPECT_EQ(exact_value("0x1p-3"), Rational(1) / Rational(8));
  EXPECT_EQ(exact_value("0x1.8p1"), Rational(3));
  EXPECT_EQ(exact_value("-0xff.fp4"), Rational(-4095));
  EXPECT_EQ(exact_value("0x10"), Rational(16));
  EXPECT_EQ(exact_value("0x1p99999") / exact_value("0x1p99998"), Rational(2));
  EXPECT_EQ(exact_value("0x1p-99999") * exact_value("0x1p99999"), Rational(1));
  EXPECT_EQ(exact_value("100000000000000000000000000000000000000000/50000000000000000000000000000000000000000"),
            Rational(2));
}

TEST(ExactNumber, of_a_hexadecimal_float_is_what_the_C_library_reads) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 10000; ++k) {
    const double value = std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 400) - 200);
    char text[64];
    std::snprintf(text, sizeof text, "%a", value);
    std::string spelled = text;
    if (const std::size_t plus = spelled.find("p+"); plus != std::string::npos) spelled.erase(plus + 1, 1);
    ASSERT_TRUE(is_exact_number(spelled)) << spelled;
    EXPECT_EQ(exact_value(spelled), exact(value)) << spelled;
    EXPECT_EQ(exact_value("-" + spelled), -exact(value)) << spelled;
  }
}

TEST(ExactNumber, is_a_double_only_if_it_has_so_few_digits) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 10000; ++k) {
    const auto whole = random() >> (random() % 64);
    char text[64];
    std::snprintf(text, sizeof text, "%s0x%llxp%d", k % 2 == 0 ? "" : "-", static_cast<unsigned long long>(whole),
                  static_cast<int>(random() % 2400) - 1200);
    const auto found = checker::as_double(text);
    if (found) {
      EXPECT_EQ(exact(*found), exact_value(text)) << text;
      EXPECT_LT(whole, std::uint64_t{1} << 52) << text;
    }
    EXPECT_EQ(checker::as_double("0x" + std::string(14, 'f')), std::nullopt);
  }
  EXPECT_EQ(checker::as_double("-0x21c6fd298c697p-48"), -0x21c6fd298c697p-48);
  EXPECT_EQ(checker::as_double("-17"), -17.0);
  for (const char* other : {"1/2", "0x1.8p1", "0x1p901", "0x1p-901", "12345678901234", "", "x"})
    EXPECT_EQ(checker::as_double(other), std::nullopt) << other;
}

TEST(ExactNumber, lies_in_its_enclosure_whatever_its_magnitude) {
  const test::Upwards upwards;
  std::mt19937_64 random(2);
  for (int k = 0; k < 20000; ++k) {
    std::string text = k % 2 == 0 ? "" : "-";
    for (std::size_t digits = 1 + random() % 60; digits > 0; --digits) text += static_cast<char>('0' + random() % 10);
    if (k % 3 == 0) text += "/" + std::to_string(1 + random() % 1000000);
    const Rational x = exact_value(text) * power(Rational(2), static_cast<int>(random() % 3000)) /
                       power(Rational(2), static_cast<int>(random() % 3000));
    const checker::Interval interval = checker::enclosure(x);
    EXPECT_TRUE(contains(interval, x));
    const double magnitude = std::fabs(interval.upper());
    if (magnitude > 1e-290 && magnitude < 1e290) {
      EXPECT_LE(interval.upper() - interval.lower(), std::ldexp(magnitude, -50));
    }
  }
}

}  // namespace
}  // namespace delcert::checker_tests
