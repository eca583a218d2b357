#include "proofs/checker/arithmetic/ball.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using checker::Ball;
using checker::in_balls;

TEST(Balls, are_computed_with_rounding_to_nearest_and_the_mode_is_as_before) {
  const test::Upwards upwards;
  volatile double one = 1, tiny = 0x1p-60;
  const slong precision = Ball::precision;
  EXPECT_GT(one + tiny, 1);
  EXPECT_EQ(in_balls(200, [&] { return Ball::precision == 200 ? one + tiny : 0; }), 1);
  EXPECT_EQ(in_balls(64, [&] { return std::fegetround(); }), FE_TONEAREST);
  EXPECT_GT(one + tiny, 1);
  EXPECT_EQ(Ball::precision, precision);
  EXPECT_THROW(in_balls(64, [&]() -> int { throw checker::Undecided("nothing"); }), checker::Undecided);
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  EXPECT_EQ(Ball::precision, precision);
}

/// Nothing keeps the compiler from moving arithmetic of doubles across a change of the mode within one function. So
/// the mode is changed in functions that have none: in in_balls, and in the two self-tests.
TEST(Balls, the_mode_is_switched_in_one_place_of_the_checker) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(DELCERT_SOURCE_DIR "/proofs/checker")) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name == "self_test.cpp" || name == "library_self_test.cpp") continue;
    std::ifstream file(entry.path());
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    const auto count = [&text](const std::string& word) {
      std::size_t times = 0;
      for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++times;
      return times;
    };
    EXPECT_EQ(count("fesetround("), name == "ball.hpp" ? 2U : 0U) << name;
    EXPECT_EQ(count("BallScope scope("), name == "ball.hpp" ? 1U : 0U) << name;
  }
}

}  // namespace
}  // namespace delcert::checker_tests
