#include "kernel/number/exact_text.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational fraction(long numerator, long denominator) { return Rational(numerator) / Rational(denominator); }

struct Form {
  const char* text;
  Rational value;
};

TEST(ExactText, every_form_is_read_as_the_number_it_denotes) {
  const std::vector<Form> forms = {
      {"0", 0},
      {"-0", 0},
      {"00012", 12},
      {"-7", -7},
      {"1000000000000000000000000000001", power(Rational(10), 30) + 1},
      {"-18446744073709551616", -Rational::power_of_two(64)},
      {"1/10", fraction(1, 10)},
      {"-6/4", fraction(-3, 2)},
      {"0/5", 0},
      {"10/5", 2},
      {"0x0", 0},
      {"0x1f", 31},
      {"-0x1", -1},
      {"0x1.8", fraction(3, 2)},
      {"0x0.001p4", fraction(1, 256)},
      {"0xa.bp0", fraction(171, 16)},
      {"0x1p-3", fraction(1, 8)},
      {"0x1p00003", 8},
      {"-0x3p-0", -3},
      {"0x1p-99999", Rational::power_of_two(-99999)},
      {"0x1p99999", Rational::power_of_two(99999)},
      {"0xffffffffffffffffffffffff", Rational::power_of_two(96) - 1},
      {"0x1.00000000000000000000000000000001", Rational(1) + Rational::power_of_two(-128)},
  };
  for (const Form& form : forms) EXPECT_TRUE(parse_exact(form.text) == form.value) << form.text;
}

TEST(ExactText, the_writer_chooses_the_form_that_the_format_prescribes) {
  const std::vector<Form> forms = {
      {"0", 0},
      {"-42", -42},
      {"9223372036854775807", INT64_MAX},
      {"-9223372036854775808", INT64_MIN},
      {"9223372036854775808", Rational::power_of_two(63)},
      {"1/2", fraction(1, 2)},
      {"-3/1024", fraction(-3, 1024)},
      {"0x3p-11", fraction(3, 2048)},
      {"-0x1fp-11", fraction(-31, 2048)},
      {"1/2049", fraction(1, 2049)},
      {"1/3000", fraction(1, 3000)},
      {"0x8000000000000001p-64", Rational(1) / 2 + Rational::power_of_two(-64)},
      {"0x1p-99999", Rational::power_of_two(-99999)},
      {"0xccccccccccccdp-55", Rational::exactly(0.1)},
      {"0x1p-1074", Rational::exactly(0x1p-1074)},
  };
  for (const Form& form : forms) EXPECT_EQ(exact_text(form.value), form.text);
}

TEST(ExactText, a_denominator_beyond_the_exponent_limit_is_written_as_a_fraction_and_read_back) {
  const Rational tiny = Rational::power_of_two(-100000);
  const std::string text = exact_text(tiny);
  EXPECT_TRUE(text.starts_with("1/"));
  EXPECT_TRUE(parse_exact(text) == tiny);
}

TEST(ExactText, random_numbers_of_every_size_survive_the_round_trip) {
  std::mt19937_64 random(20);
  for (int round = 0; round < 20000; ++round) {
    const auto integer = [&] {
      Integer result = 0;
      const auto words = random() % 4;
      for (std::uint64_t word = 0; word <= words; ++word)
        result = (result << 64) + Integer(random() >> (random() % 64));
      return random() % 2 == 0 ? result : Integer(-result);
    };
    Integer denominator = integer();
    if (denominator.is_zero()) denominator = 1;
    if (round % 2 == 0) denominator = Integer(1) << static_cast<unsigned>(random() % 300);
    const Rational value(integer(), denominator);
    const std::string text = exact_text(value);
    EXPECT_TRUE(parse_exact(text) == value) << text;
    EXPECT_EQ(text.find_first_not_of("-0123456789abcdef/xp"), std::string::npos) << text;
    EXPECT_EQ(exact_text(parse_exact(text)), text);
  }
}

TEST(ExactText, appending_leaves_what_was_there) {
  std::string text = "[";
  append_exact_text(text, Rational::power_of_two(100) - 1);
  append_exact_text(text, -3);
  EXPECT_EQ(text, "[1267650600228229401496703205375-3");
}

struct Malformed {
  std::string text;
  std::size_t position;
  const char* found;
  const char* expected;
};

TEST(ExactText, every_malformed_text_is_refused_with_its_position_and_what_was_expected) {
  const std::vector<Malformed> cases = {
      {"", 0, "the end", "a decimal digit"},
      {"-", 1, "the end", "a decimal digit"},
      {"+1", 0, "\"+\"", "a decimal digit"},
      {"--1", 1, "\"-\"", "a decimal digit"},
      {" 1", 0, "\" \"", "a decimal digit"},
      {"1 ", 1, "\" \"", "\"/\" or the end"},
      {"1\n", 1, "\"\\x0a\"", "\"/\" or the end"},
      {std::string("1\0", 2), 1, "\"\\x00\"", "\"/\" or the end"},
      {"a", 0, "\"a\"", "a decimal digit"},
      {"1a", 1, "\"a\"", "\"/\" or the end"},
      {"1e5", 1, "\"e\"", "\"/\" or the end"},
      {"0.1", 1, "\".\"", "\"x\" or the end"},
      {".5", 0, "\".\"", "a decimal digit"},
      {"nan", 0, "\"n\"", "a decimal digit"},
      {"inf", 0, "\"i\"", "a decimal digit"},
      {"1/", 2, "the end", "a decimal digit"},
      {"/2", 0, "\"/\"", "a decimal digit"},
      {"1/-2", 2, "\"-\"", "a decimal digit"},
      {"1/0", 2, "\"0\"", "a denominator other than 0"},
      {"0/000", 2, "\"0\"", "a denominator other than 0"},
      {"1/2/3", 3, "\"/\"", "a decimal digit or the end"},
      {"1/2.5", 3, "\".\"", "a decimal digit or the end"},
      {"1/0x2", 3, "\"x\"", "a decimal digit or the end"},
      {"0X1", 1, "\"X\"", "\"x\" or the end"},
      {"0x", 2, "the end", "a hexadecimal digit, lower case"},
      {"0xg", 2, "\"g\"", "a hexadecimal digit, lower case"},
      {"0xA", 2, "\"A\"", "a hexadecimal digit, lower case"},
      {"0x1A", 3, "\"A\"", "\".\", \"p\" or the end"},
      {"0x.8", 2, "\".\"", "a hexadecimal digit, lower case"},
      {"0x1.", 4, "the end", "a hexadecimal digit, lower case"},
      {"0x1.p3", 4, "\"p\"", "a hexadecimal digit, lower case"},
      {"0x1.8.8", 5, "\".\"", "\"p\" or the end"},
      {"0x1p", 4, "the end", "a decimal digit"},
      {"0x1p-", 5, "the end", "a decimal digit"},
      {"0x1p+3", 4, "\"+\"", "a decimal digit"},
      {"0x1p3.5", 5, "\".\"", "a decimal digit or the end"},
      {"0x1p3 ", 5, "\" \"", "a decimal digit or the end"},
      {"0x1pa", 4, "\"a\"", "a decimal digit"},
      {"0x1P3", 3, "\"P\"", "\"p\" or the end"},
      {"0x1p100000", 9, "\"0\"", "at most 5 digits of exponent"},
      {"0x1p-000001", 10, "\"1\"", "at most 5 digits of exponent"},
      {"0x1/2", 3, "\"/\"", "\"p\" or the end"},
      {"1p3", 1, "\"p\"", "\"/\" or the end"},
      {"\xc2\xb2", 0, "\"\\xc2\"", "a decimal digit"},
  };
  for (const Malformed& malformed : cases) {
    try {
      static_cast<void>(parse_exact(malformed.text));
      ADD_FAILURE() << "accepted: " << malformed.text;
    } catch (const ExactTextError& error) {
      EXPECT_EQ(error.position(), malformed.position) << malformed.text;
      EXPECT_EQ(error.found(), malformed.found) << malformed.text;
      EXPECT_NE(error.expected().find(malformed.expected), std::string::npos) << malformed.text << error.expected();
      EXPECT_NE(std::string(error.what()).find(error.expected()), std::string::npos) << error.what();
    }
  }
}

std::string hint_for(const char* text) {
  try {
    static_cast<void>(parse_exact(text));
  } catch (const ExactTextError& error) {
    return error.hint();
  }
  return "accepted";
}

TEST(ExactText, a_decimal_point_is_answered_with_the_fraction_to_write) {
  EXPECT_EQ(hint_for("0.1"), "decimal points are not accepted: write 1/10");
  EXPECT_EQ(hint_for("-12.50"), "decimal points are not accepted: write -1250/100");
  EXPECT_EQ(hint_for("0.00"), "decimal points are not accepted: write 0/100");
  EXPECT_EQ(hint_for("1.5e3"), "decimal points are not accepted: write a fraction, 1/10");
  EXPECT_EQ(hint_for(".5"), "decimal points are not accepted: write a fraction, 1/10");
  EXPECT_EQ(hint_for("1/2x"), "");
  EXPECT_EQ(hint_for("0x1p3.5"), "");
}

TEST(ExactText, long_malformed_text_is_cut_in_the_message) {
  try {
    static_cast<void>(parse_exact(std::string(1000000, '7') + "?"));
    FAIL();
  } catch (const ExactTextError& error) {
    EXPECT_LT(std::string(error.what()).size(), 250U);
    EXPECT_EQ(error.position(), 1000000U);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
