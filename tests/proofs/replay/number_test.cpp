#include "proofs/replay/number.hpp"

#include <gtest/gtest.h>

namespace delcert::replay {
namespace DELCERT_THIS_FILE {

TEST(ReplayNumber, is_read_exactly_or_refused) {
  EXPECT_EQ(Number::read("6/8").text(), "3/4");
  EXPECT_EQ(Number::read("-7").text(), "-7");
  EXPECT_EQ(Number::read("0").sign(), 0);
  for (const char* wrong : {"", "x", "1/0", "1.5", "1e3", "-", "/", "1/", " 1", "1 "}) {
    EXPECT_THROW((void)Number::read(wrong), Malformed) << wrong;
  }
}

TEST(ReplayNumber, reckons) {
  const Number a = Number::read("3/4");
  EXPECT_EQ((a + a - Number(1)).text(), "1/2");
  EXPECT_EQ((a * a / Number(3)).text(), "3/16");
  EXPECT_TRUE(a < Number(1) && a <= a && !(a < a) && !a.is_integer() && Number(2).is_integer());
}

TEST(ReplayNumber, a_side_is_a_point_if_its_ends_are_equal) {
  Side side;
  EXPECT_FALSE(side.is_point());
  side.lower = Number(2);
  side.upper = Number(2);
  EXPECT_TRUE(side.is_point());
  side.upper = Number(3);
  EXPECT_FALSE(side.is_point());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::replay
