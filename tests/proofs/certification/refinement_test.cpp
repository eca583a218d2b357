#include "proofs/certification/refinement.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

Refinement of(const std::vector<FailedRound>& rounds) {
  Refinement result;
  for (const FailedRound& round : rounds) result.add(round);
  return result;
}

TEST(Refinement, goes_on_while_fewer_places_fail) {
  EXPECT_FALSE(of({}).has_stalled());
  EXPECT_FALSE(of({{"level 5", 900, 1000}}).has_stalled());
  EXPECT_FALSE(of({{"level 5", 900, 1000}, {"level 5", 899, 3000}}).has_stalled());
  EXPECT_FALSE(of({{"charts", 1, 0}, {"charts", 1, 0}, {"charts", 1, 0}}).has_stalled());
  // A run that comes farther has failed at other places.
  EXPECT_FALSE(
      of({{"charts", 3, 0}, {"stars", 7, 1000}, {"level 5", 900, 1000}, {"level 5i", 950, 2000}}).has_stalled());
}

TEST(Refinement, has_stalled_where_as_many_places_fail_as_before) {
  EXPECT_TRUE(of({{"level 5i", 900, 1000}, {"level 5i", 900, 3000}}).has_stalled());
  // A few may be others by accident, once.
  EXPECT_FALSE(of({{"level 5i", 9, 1000}, {"level 5i", 12, 1100}}).has_stalled());
  EXPECT_TRUE(of({{"level 5i", 9, 1000}, {"level 5i", 12, 1100}, {"level 5i", 12, 1300}}).has_stalled());
  EXPECT_FALSE(of({{"level 5i", 9, 1000}, {"level 5i", 12, 1100}, {"level 5i", 2, 1300}}).has_stalled());
}

TEST(Refinement, says_how_it_goes) {
  EXPECT_EQ(of({}).text(), "");
  EXPECT_EQ(of({{"level 5", 120, 12000}}).text(), "refined 1 times, level 5 failed at 120 of 12000 points");
  EXPECT_EQ(of({{"level 5", 160, 12000}, {"level 5", 40, 13000}}).text(),
            "refined 2 times, level 5 failed at 40 of 13000 points, at 160 the time before, some 4 more rounds");
  EXPECT_EQ(
      of({{"level 5i", 900, 1000}, {"level 5i", 950, 3000}}).reason(),
      "refinement does not help any more: after 1 rounds level 5i fails at 950 of 3000 points, and failed at 900 of "
      "1000 the round before; a smaller --radius, or a smaller first number in --sizing, may");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
