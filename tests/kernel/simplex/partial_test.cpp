#include "kernel/simplex/partial.hpp"

#include <gtest/gtest.h>

namespace DELCERT_THIS_FILE {

using delcert::Partial;
using delcert::Verdict;

TEST(Partial, ExistsExactlyWhenItHasAValue) {
  const Partial<int> present(7);
  ASSERT_TRUE(present);
  EXPECT_EQ(*present, 7);
  EXPECT_EQ(present.exists(), Verdict::proved);
}

TEST(Partial, SaysWhetherItsAbsenceIsCertain) {
  EXPECT_FALSE(Partial<int>::absent(Verdict::refuted));
  EXPECT_EQ(Partial<int>::absent(Verdict::refuted).exists(), Verdict::refuted);
  EXPECT_FALSE(Partial<int>::absent(Verdict::undecided));
  EXPECT_EQ(Partial<int>::absent(Verdict::undecided).exists(), Verdict::undecided);
}

}  // namespace DELCERT_THIS_FILE
