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
  EXPECT_EQ(drawn(), "\r\x1b[Kstars: 5/10 (50 %), 1 s, about 2 s left");
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

TEST_F(ProgressLineTest, writes_plain_lines_where_there_is_no_terminal_if_asked) {
  ProgressLine plain(stream, false, [this] { return time; });
  plain.also_without_terminal(milliseconds(60000));
  plain.update("attack", 100, 1000);
  pass(59000);
  plain.update("attack", 150, 1000);
  EXPECT_EQ(drawn(), "");
  pass(1000);
  plain.update("attack", 200, 1000);
  EXPECT_EQ(drawn(), "attack: 200/1000 (20 %), 60 s, about 8 min left\n");
  plain.clear();
  EXPECT_EQ(drawn(), "");
  // On a terminal the line that is drawn stays as it is.
  line.also_without_terminal(milliseconds(60000));
  line.update("attack", 0, 10);
  pass(1000);
  line.update("attack", 5, 10);
  EXPECT_EQ(drawn(), "\r\x1b[Kattack: 5/10 (50 %), 1 s, about 1 s left");
}

TEST_F(ProgressLineTest, what_was_there_before_says_nothing_of_the_rate) {
  line.update("attack", 900, 1000);
  pass(10000);
  line.update("attack", 910, 1000);
  EXPECT_EQ(drawn(), "\r\x1b[Kattack: 910/1000 (91 %), 10 s, about 90 s left");
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
