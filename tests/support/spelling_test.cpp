#include "support/spelling.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Spelling, distance_counts_inserted_deleted_and_replaced_characters) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("thickness", "thicknes"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("ab", "ba"), 2U);
}

TEST(Spelling, the_nearest_word_is_suggested) {
  const std::vector<std::string> words{"thickness", "circumradius", "shortest_edge"};
  EXPECT_EQ(suggestion("thicknes", words), ", did you mean thickness?");
  EXPECT_EQ(suggestion("circumradus", words), ", did you mean circumradius?");
  EXPECT_EQ(suggestion("volume", words), "");
  EXPECT_EQ(suggestion("q", std::vector<std::string>{"k"}), "");
  EXPECT_EQ(suggestion("mu", std::vector<std::string>{"mu0"}), ", did you mean mu0?");
  EXPECT_EQ(suggestion(std::string(1000000, 'a'), words), "");
  EXPECT_EQ(suggestion("x", std::vector<std::string>{}), "");
}

TEST(Spelling, words_that_begin_so_are_suggested_if_they_are_few) {
  const std::vector<std::string> words{"bolza-surface",  "klein-bottle", "klein-quartic", "torus-2",
                                       "torus-2-skewed", "torus-3",      "torus-4"};
  EXPECT_EQ(suggestion("bolza", words), ", did you mean bolza-surface?");
  EXPECT_EQ(suggestion("klein", words), ", did you mean klein-bottle or klein-quartic?");
  EXPECT_EQ(suggestion("surface", words), "");
  EXPECT_EQ(suggestion("kl", words), "");
  EXPECT_EQ(suggestion("torus", std::vector<std::string>{"torus-of-a", "torus-of-b", "torus-of-c", "torus-of-d"}), "");
  EXPECT_EQ(suggestion("lens", std::vector<std::string>{"lens-space-5-2", "lens-space-7-2", "lens-space-8-3"}),
            ", did you mean lens-space-5-2, lens-space-7-2 or lens-space-8-3?");
}

TEST(Spelling, a_text_of_a_user_is_shown_on_one_short_line) {
  EXPECT_EQ(shortened("plain"), "plain");
  EXPECT_EQ(shortened("a\nb\tc\x7f"), "a?b?c?");
  EXPECT_EQ(shortened(std::string(60, 'a')), std::string(60, 'a'));
  EXPECT_EQ(shortened(std::string(61, 'a')), std::string(60, 'a') + "...");
  // The last character has two bytes, of which only one would fit.
  EXPECT_EQ(shortened(std::string(59, 'a') + "\u03b5\u03b5"), std::string(59, 'a') + "...");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
