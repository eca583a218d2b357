#include "apps/progress_line.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <sstream>

#include "apps/interruption.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using std::chrono::milliseconds;

/// A line on a stream, with a clock that stands still unless told.
class ProgressLineTest : public ::testing::Test {
 protected:
  void pass(int ms) { time += milliseconds(ms); }
  std::string drawn() {
    std::string text = stream.str();
    stream.str("");
    return text;
  }

  ProgressLine::Clock::time_point time{milliseconds(1000000)};
  std::ostringstream stream;
  ProgressLine line{stream, true, [this] { return time; }};
};

TEST_F(ProgressLineTest, says_how_far_the_work_has_come_and_how_long_it_will_take) {
  line.update("perturbing", 0, 1000);
  pass(2000);
  line.update("perturbing", 400, 1000);
  EXPECT_EQ(drawn(), "\r\x1b[Kperturbing: 400/1000 (40 %), 2 s, about 3 s left");
  pass(3000);
  line.update("perturbing", 1000, 1000);
  EXPECT_EQ(drawn(), "\r\x1b[Kperturbing: 1000/1000 (100 %), 5 s");
}

TEST_F(ProgressLineTest, is_not_drawn_for_short_work_or_too_often) {
  line.update("stars", 1, 10);
  pass(150);
  line.update("stars", 2, 10);
  EXPECT_EQ(drawn(), "");
  pass(100);
  line.update("stars", 3, 10);
  EXPECT_NE(drawn(), "");
  pass(50);
  line.update("stars", 4, 10);
  EXPECT_EQ(drawn(), "");
}

TEST_F(ProgressLineTest, times_each_stage_by_itself) {
  line.update("net", 1, 10);
  pass(60000);
  line.update("stars", 1, 10);
  EXPECT_EQ(drawn(), "");
  pass(1000);
  line.update("stars", 5, 10);
  EXPECT_EQ(drawn(), "\r\x1b[Kstars: 5/10 (50 %), 1 s, about 1 s left");
}

TEST_F(ProgressLineTest, counts_where_the_total_is_not_known) {
  line.update("reading", 0, 0);
  pass(1000);
  line.update("reading", 77, 0);
  EXPECT_EQ(drawn(), "\r\x1b[Kreading: 77, 1 s");
}

TEST_F(ProgressLineTest, shows_long_times_in_minutes_and_hours) {
  line.update("stars", 0, 100);
  pass(180000);
  line.update("stars", 1, 100);
  EXPECT_EQ(drawn(), "\r\x1b[Kstars: 1/100 (1 %), 3 min, about 4 h 57 min left");
}

TEST_F(ProgressLineTest, is_removed_once) {
  line.clear();
  EXPECT_EQ(drawn(), "");
  line.update("stars", 0, 10);
  pass(1000);
  line.update("stars", 1, 10);
  drawn();
  line.clear();
  EXPECT_EQ(drawn(), "\r\x1b[K");
  line.clear();
  EXPECT_EQ(drawn(), "");
}

TEST_F(ProgressLineTest, is_silent_where_it_is_not_shown) {
  ProgressLine silent(stream, false, [this] { return time; });
  silent.update("stars", 0, 10);
  pass(1000);
  silent.update("stars", 1, 10);
  EXPECT_EQ(drawn(), "");
}

TEST_F(ProgressLineTest, lets_work_be_interrupted) {
  catch_interruptions();
  const Progress progress = line.callback();
  EXPECT_NO_THROW(progress("stars", 0, 10));
  std::raise(SIGINT);
  EXPECT_THROW(progress("stars", 1, 10), Interrupted);
  catch_interruptions();
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
