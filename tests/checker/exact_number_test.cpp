#include "proofs/checker/arithmetic/exact_number.hpp"

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

TEST(ExactNumber, is_read_as_what_its_first_digits_enclose) {
  std::mt19937_64 random(3);
  int read = 0;
  for (int k = 0; k < 10000; ++k) {
    const auto whole = random() >> (random() % 64);
    char text[96];
    std::snprintf(text, sizeof text, "%s0x%llxp%d", k % 2 == 0 ? "" : "-", static_cast<unsigned long long>(whole),
                  static_cast<int>(random() % 2400) - 1200);
    const auto found = checker::read_enclosure(text);
    if (!found) continue;
    ++read;
    const Rational x = exact_value(text);
    EXPECT_TRUE(contains(*found, x)) << text;
    const double magnitude = std::fabs(found->upper());
    EXPECT_LE(found->upper() - found->lower(), std::ldexp(magnitude, -52)) << text;
    const bool is_double =
        whole == static_cast<std::uint64_t>(static_cast<double>(whole >> 11)) << 11 || whole >> 53 == 0;
    if (is_double) {
      EXPECT_EQ(found->lower(), found->upper()) << text;
    }
    // With more digits, which may all be 0 or f.
    const std::string more(1 + random() % 20, random() % 2 == 0 ? '0' : 'f');
    std::snprintf(text, sizeof text, "0x%llx%sp%d", static_cast<unsigned long long>(whole), more.c_str(),
                  static_cast<int>(random() % 600) - 300);
    const auto longer = checker::read_enclosure(text);
    EXPECT_TRUE(!longer || contains(*longer, exact_value(text))) << text;
  }
  EXPECT_GT(read, 5000);
  const auto is_read_as = [](const char* text, double lower, double upper) {
    const auto found = checker::read_enclosure(text);
    EXPECT_TRUE(found && found->lower() == lower && found->upper() == upper) << text;
  };
  is_read_as("-0x21c6fd298c697p-48", -0x21c6fd298c697p-48, -0x21c6fd298c697p-48);
  is_read_as("-17", -17, -17);
  is_read_as("0x1p900", 0x1p900, 0x1p900);
  is_read_as("-0x3p-900", -0x3p-900, -0x3p-900);
  is_read_as("0x80000000000007ffp-10", 0x1p53, 0x1.0000000000001p53);
  is_read_as("-0x80000000000008000000p0", -0x1.0000000000001p79, -0x1.0000000000001p79);
  is_read_as("-0x80000000000008000001p0", -0x1.0000000000002p79, -0x1.0000000000001p79);
  is_read_as("9007199254740993", 0x1p53, 0x1p53 + 2);
  for (const char* other : {"1/2", "0x1.8p1", "0x1p901", "0x1p-901", "12345678901234567", "0x00000000000000001p0",
                            "0x00001000000000000001p0", "", "x"})
    EXPECT_EQ(checker::read_enclosure(other), std::nullopt) << other;
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
