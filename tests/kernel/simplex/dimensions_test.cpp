#include "kernel/simplex/dimensions.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

int chosen(int dimension) {
  return with_dimension(Dimension(dimension), []<int m>() { return m; });
}

TEST(WithDimension, calls_the_instance_of_the_dimension) {
  for (int m = 1; m <= largest_run_dimension; ++m) EXPECT_EQ(chosen(m), m);
}

TEST(WithDimension, refuses_every_other_dimension) {
  for (const int m : {-1, 0, largest_run_dimension + 1, 1000}) EXPECT_THROW((void)chosen(m), std::out_of_range);
}

TEST(ForEachDimension, names_each_dimension_of_runs_once) {
  int count = 0;
  int total = 0;
#define DELCERT_COUNT(m) ++count, total += (m);
  DELCERT_FOR_EACH_DIMENSION(DELCERT_COUNT)
#undef DELCERT_COUNT
  EXPECT_EQ(count, largest_run_dimension);
  EXPECT_EQ(total, largest_run_dimension * (largest_run_dimension + 1) / 2);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
