#include "apps/exact_option.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace delcert {
namespace DELCERT_THIS_FILE {

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

TEST(ExactOption, may_be_left_out) {
  for (const std::string command_line : {"", "--x 1/2"}) {
    CLI::App app;
    std::optional<Rational> value;
    add_exact_option(app, "--x", value, "a number");
    app.parse(command_line);
    EXPECT_EQ(value.has_value(), !command_line.empty());
    EXPECT_EQ(value.value_or(Rational(0)), command_line.empty() ? Rational(0) : Rational(1) / Rational(2));
  }
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

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
