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
