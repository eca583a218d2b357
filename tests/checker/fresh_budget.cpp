// Each test may do any work that it does not bound itself, whatever the tests before it in the same process have left.

#include <gtest/gtest.h>

#include "proofs/checker/report/budget.hpp"

namespace delcert::checker_tests {
namespace {

struct FreshBudget : testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo& /*test*/) override { checker::Budget::open(std::uint64_t{1} << 44); }
};

[[maybe_unused]] const bool is_listening = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new FreshBudget);  // which owns it
  return true;
}();

}  // namespace
}  // namespace delcert::checker_tests
