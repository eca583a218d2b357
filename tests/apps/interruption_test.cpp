#include "apps/interruption.hpp"

#include <gtest/gtest.h>

#include <csignal>

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

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
