#include "kernel/formula/expression.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Expressions, comparisons_are_five) {
  std::vector<Operation> comparisons;
  for (int at = 0; at <= static_cast<int>(Operation::exists); ++at) {
    const auto operation = static_cast<Operation>(at);
    if (is_comparison(operation)) comparisons.push_back(operation);
  }
  EXPECT_EQ(comparisons, (std::vector<Operation>{Operation::less, Operation::less_equal, Operation::greater,
                                                 Operation::greater_equal, Operation::equal}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
