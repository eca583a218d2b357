#include "proofs/tables/constant_rows.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

const std::string row = "[[constant]]\nlabel = 'l'\nstatement = 's'\nlatex = 'x'\nbest = 'smaller'\n";

std::string message_of(const std::string& text) {
  try {
    (void)parse_constant_rows(text, "f.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ConstantRows, are_read_with_all_that_they_say) {
  const ConstantRows rows = parse_constant_rows(
      row + "claim = 'a'\nconclusion = 'b'\npattern = 'C < 1'\npaper = '2/3'\nsteps = ['a/b/c']\ninverse = true\n" +
          "note = 'n'\n[[without]]\nlabel = 'm'\nreason = 'r'\n",
      "f.toml");
  ASSERT_EQ(rows.rows.size(), 1U);
  EXPECT_EQ(rows.rows[0].claim, "a");
  EXPECT_EQ(rows.rows[0].conclusion, "b");
  EXPECT_EQ(rows.rows[0].pattern, "C < 1");
  EXPECT_EQ(rows.rows[0].paper, Rational(2) / Rational(3));
  EXPECT_EQ(rows.rows[0].steps, std::vector<std::string>{"a/b/c"});
  EXPECT_TRUE(rows.rows[0].is_inverse_in_steps);
  EXPECT_EQ(rows.rows[0].direction, Direction::smaller);
  ASSERT_EQ(rows.without.size(), 1U);
  EXPECT_EQ(rows.without[0].reason, "r");
}

TEST(ConstantRows, are_refused_with_the_place_of_what_is_wrong) {
  EXPECT_EQ(message_of(row), "f.toml:1:1: a constant is that of a claim or of a step");
  EXPECT_EQ(message_of(row + "steps = ['a/b']\n"), "f.toml:6:10: a constant of a step is \"claim/step/constant\"");
  EXPECT_EQ(message_of(row + "claim = 'a'\n"), "f.toml:1:1: the key conclusion is missing");
  EXPECT_EQ(message_of(row + "stpes = ['a/b/c']\n"), "f.toml:6:1: unknown key stpes, did you mean steps?");
  EXPECT_EQ(message_of("[[constant]]\nlabel = ''\n"), "f.toml:2:9: the key label expects a string that is not empty");
  EXPECT_NE(message_of(row + "steps = ['a/b/c']\npaper = '0.5'\n").find("f.toml:7:9: "), std::string::npos);
  EXPECT_NE(message_of("constant = 3\n").find("f.toml:1:12: the key constant expects a list"), std::string::npos);
}

TEST(ConstantRows, of_the_library_are_well_formed) {
  EXPECT_GT(builtin_constant_rows().rows.size(), 30U);
  EXPECT_FALSE(builtin_constant_rows().without.empty());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
