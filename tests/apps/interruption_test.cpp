#include "apps/interruption.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Interruption, is_noticed_by_work_that_asks) {
  for (const int signal : {SIGINT, SIGTERM}) {
    catch_interruptions();
    EXPECT_NO_THROW(throw_if_interrupted());
    std::raise(signal);
    EXPECT_THROW(throw_if_interrupted(), Interrupted);
    EXPECT_THROW(throw_if_interrupted(), Interrupted);
  }
  catch_interruptions();
  EXPECT_NO_THROW(throw_if_interrupted());
}

TEST(InterruptionDeathTest, ends_the_program_when_it_comes_twice) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        catch_interruptions();
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      ::testing::KilledBySignal(SIGINT), "");
}

/// As work that does not ask.
void sleep_for_a_minute() { std::this_thread::sleep_for(std::chrono::minutes(1)); }

TEST(InterruptionDeathTest, ends_work_that_does_not_ask_when_its_deadline_is_over) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const int signal : {SIGINT, SIGTERM}) {
    EXPECT_EXIT(
        {
          catch_interruptions();
          const InterruptionDeadline deadline("over", std::chrono::milliseconds(10));
          std::raise(signal);
          sleep_for_a_minute();
        },
        ::testing::ExitedWithCode(130), "^delcert: error: over\n$");
  }
}

TEST(InterruptionDeathTest, leaves_work_alone_that_ends_in_time) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        catch_interruptions();
        {
          const InterruptionDeadline deadline("over", std::chrono::seconds(30));
          std::raise(SIGTERM);
        }
        catch_interruptions();
        { const InterruptionDeadline nobody_interrupts("over", std::chrono::milliseconds(0)); }
        std::_Exit(7);
      },
      ::testing::ExitedWithCode(7), "^$");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
