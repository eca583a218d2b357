#include "apps/list_option.hpp"

#include <gtest/gtest.h>

#include <string>

namespace delcert {
namespace DELCERT_THIS_FILE {

std::vector<Rational> numbers(const std::string& text) {
  CLI::App app;
  std::vector<Rational> values;
  add_exact_list_option(app, "--x", values, "numbers");
  app.parse("--x " + text);
  return values;
}

std::vector<int> integers(const std::string& text) {
  CLI::App app;
  std::vector<int> values;
  add_integer_list_option(app, "--x", values, "integers");
  app.parse("--x " + text);
  return values;
}

template <class Read>
std::string message_of(const Read& read, const std::string& text) {
  try {
    (void)read(text);
  } catch (const CLI::ValidationError& error) {
    return error.what();
  }
  return "accepted";
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(ListOption, reads_exact_numbers_in_their_order) {
  EXPECT_EQ(numbers("1/2"), std::vector<Rational>{Rational(1) / Rational(2)});
  EXPECT_EQ(numbers("1,1/4,0x1p-1"),
            (std::vector<Rational>{Rational(1), Rational(1) / Rational(4), Rational(1) / Rational(2)}));
}

TEST(ListOption, reads_integers_and_ranges) {
  EXPECT_EQ(integers("2"), std::vector<int>{2});
  EXPECT_EQ(integers("2..6"), (std::vector<int>{2, 3, 4, 5, 6}));
  EXPECT_EQ(integers("5,1..2,3..3"), (std::vector<int>{5, 1, 2, 3}));
  EXPECT_EQ(integers("-1..1"), (std::vector<int>{-1, 0, 1}));
}

TEST(ListOption, refuses_what_is_no_list_of_numbers) {
  EXPECT_TRUE(mentions(message_of(numbers, "1/2,,1"), "an empty part in \"1/2,,1\""));
  EXPECT_TRUE(mentions(message_of(numbers, "1/2,"), "an empty part"));
  EXPECT_TRUE(mentions(message_of(numbers, "1,0.5"), "write 5/10"));
  EXPECT_TRUE(mentions(message_of(numbers, "1;2"), "1;2"));
  EXPECT_TRUE(mentions(message_of(numbers, "1/2,2/4"), "2/4 lists a value a second time"));
}

TEST(ListOption, refuses_what_is_no_list_of_integers) {
  for (const char* text : {"2..", "..2", "2...3", "a", "2,", "1/2", "2.5", "1..2..3", "99999999999"})
    EXPECT_TRUE(mentions(message_of(integers, text), "is neither an integer nor a range")) << text;
  EXPECT_TRUE(mentions(message_of(integers, "6..2"), "the range 6..2 ends below its beginning"));
  EXPECT_TRUE(mentions(message_of(integers, "1..3,2"), "2 lists a value a second time"));
  EXPECT_TRUE(mentions(message_of(integers, "1..2000000000"), "more than 1000 values"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
