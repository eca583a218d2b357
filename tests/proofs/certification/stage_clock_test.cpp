#include "proofs/certification/stage_clock.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

std::vector<std::string> names_of(const std::vector<StageClock::Stage>& stages) {
  std::vector<std::string> result;
  for (const auto& stage : stages) result.push_back(stage.name);
  return result;
}

TEST(StageClock, a_stage_begins_with_its_first_report_and_repeated_ones_are_one) {
  StageClock clock;
  std::size_t reports = 0;
  const Progress progress = clock.callback([&reports](std::string_view, std::size_t, std::size_t) { ++reports; });
  progress("stars", 0, 2);
  progress("stars", 1, 2);
  clock.begin("write");
  progress("stars", 2, 2);
  EXPECT_EQ(names_of(clock.finish()), (std::vector<std::string>{"stars", "write"}));
  EXPECT_EQ(reports, 3U);
}

TEST(StageClock, decisions_belong_to_the_stage_in_which_they_are_made) {
  StageClock clock;
  clock.begin("first");
  ladder_statistics().undecided += 2;
  clock.begin("second");
  ladder_statistics().undecided += 1;
  const auto stages = clock.finish();
  ladder_statistics().undecided += 5;
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_EQ(stages[0].decisions.undecided, 2U);
  EXPECT_EQ(stages[1].decisions.undecided, 1U);
  EXPECT_GE(stages[0].seconds, 0);
  EXPECT_TRUE(StageClock().finish().empty());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
