#include "proofs/drawing/manifold/upper_triangle.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(UpperTriangle, ProductAndSolution) {
  // ( 2 3 5 )
  // (   7 1 )
  // (     4 )
  const std::vector<double> entries{2, 3, 5, 7, 1, 4};
  const std::vector<double> product = triangle_times(entries, {1, -1, 2});
  EXPECT_EQ(product, (std::vector<double>{9, -5, 8}));
  EXPECT_EQ(triangle_solution(entries, product), (std::vector<double>{1, -1, 2}));
  EXPECT_NE(triangle_solution(entries, product), triangle_solution(entries, {9, -5, 4}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
