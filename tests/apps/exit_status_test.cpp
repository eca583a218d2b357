#include "apps/exit_status.hpp"

#include <gtest/gtest.h>

#include <new>
#include <sstream>
#include <stdexcept>

#include "apps/interruption.hpp"
#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

struct Outcome {
  ExitStatus status;
  std::string errors;
};

Outcome outcome_of(const Action& action) {
  std::ostringstream errors;
  const ExitStatus status = run_reporting(action, errors);
  return {status, errors.str()};
}

template <class Exception>
Outcome outcome_of_throwing(Exception exception) {
  return outcome_of([&]() -> ExitStatus { throw exception; });
}

TEST(ExitStatus, has_the_documented_values) {
  EXPECT_EQ(static_cast<int>(ExitStatus::verified), 0);
  EXPECT_EQ(static_cast<int>(ExitStatus::rejected), 1);
  EXPECT_EQ(static_cast<int>(ExitStatus::undecided), 2);
  EXPECT_EQ(static_cast<int>(ExitStatus::malformed), 3);
  EXPECT_EQ(static_cast<int>(ExitStatus::usage), 64);
  EXPECT_EQ(static_cast<int>(ExitStatus::internal), 70);
  EXPECT_EQ(static_cast<int>(ExitStatus::interrupted), 130);
}

TEST(ExitStatus, of_an_action_that_returns_is_what_it_returns) {
  const Outcome outcome = outcome_of([] { return ExitStatus::rejected; });
  EXPECT_EQ(outcome.status, ExitStatus::rejected);
  EXPECT_EQ(outcome.errors, "");
}

TEST(ExitStatus, tells_the_kinds_of_failure_apart) {
  EXPECT_EQ(outcome_of_throwing(Rejection("no")).status, ExitStatus::rejected);
  EXPECT_EQ(outcome_of_throwing(Undecided("perhaps")).status, ExitStatus::undecided);
  EXPECT_EQ(outcome_of_throwing(InputError("what?")).status, ExitStatus::malformed);
  EXPECT_EQ(outcome_of_throwing(Interrupted()).status, ExitStatus::interrupted);
  EXPECT_EQ(outcome_of_throwing(std::logic_error("bug")).status, ExitStatus::internal);
  EXPECT_EQ(outcome_of_throwing(std::bad_alloc()).status, ExitStatus::internal);
  EXPECT_EQ(outcome_of_throwing(7).status, ExitStatus::internal);
}

TEST(ExitStatus, comes_with_one_line_of_explanation) {
  EXPECT_EQ(outcome_of_throwing(InputError("f.toml:1:2: key")).errors, "delcert: error: f.toml:1:2: key\n");
  EXPECT_EQ(outcome_of_throwing(std::logic_error("bug")).errors, "delcert: error: internal: bug\n");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
