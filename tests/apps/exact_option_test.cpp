#include "apps/exact_option.hpp"

#include <gtest/gtest.h>

#include <string>

namespace delcert {
namespace {

Rational value_of(const std::string& command_line) {
  CLI::App app;
  Rational value(7);
  add_exact_option(app, "--x", value, "a number");
  app.parse(command_line);
  return value;
}

TEST(ExactOption, reads_every_form_of_an_exact_number) {
  EXPECT_EQ(value_of("--x 3"), Rational(3));
  EXPECT_EQ(value_of("--x -3/4"), Rational(-3) / Rational(4));
  EXPECT_EQ(value_of("--x=0x3p-2"), Rational(3) / Rational(4));
  EXPECT_EQ(value_of(""), Rational(7));
}

TEST(ExactOption, refuses_everything_else_as_a_usage_error) {
  EXPECT_THROW((void)value_of("--x 0.75"), CLI::ValidationError);
  EXPECT_THROW((void)value_of("--x 1/0"), CLI::ValidationError);
  EXPECT_THROW((void)value_of("--x"), CLI::ParseError);
  try {
    (void)value_of("--x 0.75");
  } catch (const CLI::ValidationError& error) {
    EXPECT_NE(std::string(error.what()).find("write 75/100"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace delcert
