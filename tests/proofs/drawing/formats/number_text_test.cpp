#include "proofs/drawing/formats/number_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace delcert {
namespace DELCERT_THIS_FILE {

std::string measure_text(double value) {
  std::string text;
  append_measure(text, value);
  return text;
}

TEST(NumberText, HasIntegersAndDoublesAsFmtWritesThem) {
  std::string text = "x";
  append_number(text, std::uint32_t{4294967295});
  text += ' ';
  append_number(text, -7);
  text += ' ';
  append_number(text, 0.1);
  text += ' ';
  append_number(text, 1e-7);
  EXPECT_EQ(text, "x4294967295 -7 0.1 1e-07");
}

TEST(NumberText, RoundsToNineDigitsAsPrintfDoes) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> values{
      0.0,         -0.0,        1,      -1,       0.5,       100,         123456789,       1234567890,
      999999999.5, 999999999.4, 0.1,    1.0 / 3,  -2.0 / 3,  1e-4,        9.9999999949e-5, 0.00099999999995,
      12.5,        1e300,       5e-324, infinity, -infinity, std::nan("")};
  // Halfway between two texts, as exactly as doubles can be.
  for (int k = 0; k < 200; ++k) values.push_back((2 * k + 1) * 0x1p-10 + 1000000);
  std::mt19937_64 random(1);
  for (int k = 0; k < 20000; ++k) {
    const double mantissa = std::uniform_real_distribution<double>(-1, 1)(random);
    const int exponent = std::uniform_int_distribution<int>(-60, 40)(random);
    values.push_back(std::ldexp(mantissa, exponent));
    values.push_back(std::round(mantissa * 1000) / 1000);
  }
  for (const double value : values) {
    EXPECT_EQ(measure_text(value), fmt::format("{:.9g}", value));
    for (const double towards : {-infinity, infinity})
      EXPECT_EQ(measure_text(std::nextafter(value, towards)), fmt::format("{:.9g}", std::nextafter(value, towards)));
  }
  EXPECT_NE(measure_text(0.123456789), measure_text(0.123456788));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
