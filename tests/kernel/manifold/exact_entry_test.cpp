#include "kernel/manifold/exact_entry.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

Rational read(const std::string& value) {
  const std::string text = "a = " + value;
  const TomlReader reader(text, "x.toml");
  const toml::table table = reader.parse();
  return exact_number(reader, reader.required(table, "a"), "the number");
}

std::string refusal(const std::string& value) {
  return message_of<InputError>([&] { (void)read(value); });
}

std::array<Rational, 2> read_interval(const std::string& value) {
  const std::string text = "a = " + value;
  const TomlReader reader(text, "x.toml");
  const toml::table table = reader.parse();
  return exact_interval(reader, reader.required(table, "a"), "the side");
}

std::string refusal_of_interval(const std::string& value) {
  return message_of<InputError>([&] { (void)read_interval(value); });
}

TEST(ExactEntry, is_an_interval_if_its_ends_are_in_order) {
  EXPECT_EQ(read_interval("[-1, \"1/2\"]"), (std::array<Rational, 2>{Rational(-1), ratio(1, 2)}));
  EXPECT_TRUE(mentions(refusal_of_interval("[1]"), "x.toml:1:5: the side: "));
  EXPECT_TRUE(mentions(refusal_of_interval("[1, 2, 3]"), "expected a pair of numbers"));
  EXPECT_TRUE(mentions(refusal_of_interval("[\"1/2\", \"1/2\"]"), "x.toml:1:13: the side, to: "));
  EXPECT_TRUE(mentions(refusal_of_interval("[0, 0.5]"), "x.toml:1:9: the side, to: "));
}

TEST(ExactEntry, is_an_integer_or_a_text) {
  EXPECT_EQ(read("-3"), Rational(-3));
  EXPECT_EQ(read("\"3/4\""), ratio(3, 4));
  EXPECT_EQ(read("\"0x3p-2\""), ratio(3, 4));
}

TEST(ExactEntry, is_nothing_else) {
  EXPECT_EQ(refusal("0.5"),
            "x.toml:1:5: the number: found the floating-point number 0.5, expected an exact number: an integer, or a "
            "string such as \"3/4\" or \"0x3p-2\"; a floating-point number would be rounded before it is read");
  EXPECT_TRUE(mentions(refusal("true"), "x.toml:1:5: the number: found the boolean true, expected an exact number"));
  EXPECT_TRUE(mentions(refusal("\"3/\""), "x.toml:1:5: the number: "));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
