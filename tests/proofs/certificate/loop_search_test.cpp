#include "proofs/certificate/loop_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delcert {
namespace DELCERT_THIS_FILE {

/// Translations of the line by integers; label j is at j/4.
struct Steps {
  using Motion = int;
  std::vector<int> elements{0, -1};

  [[nodiscard]] int identity() const { return 0; }
  [[nodiscard]] int of(std::uint32_t number) const { return elements[number]; }
  [[nodiscard]] int inverse_of(std::uint32_t number) const { return -elements[number]; }
  [[nodiscard]] int product(int a, int b) const { return a + b; }
  [[nodiscard]] bool are_same(int a, int b) const { return a == b; }
  [[nodiscard]] double remaining(std::uint32_t label, int a, int target) const {
    return std::abs(label / 4.0 + a - target);
  }
};

/// Four edges around a circle; the last is from 0 to the lift of 3 before it.
const std::vector<PlacedSimplex<1>> circle{{0, 1, 0}, {0, 3, 1}, {1, 2, 0}, {2, 3, 0}};

TEST(LoopSearch, GoesRoundACircle) {
  const Steps steps;
  LoopSearch<1, Steps> search(circle, 4, steps);
  const std::vector<LoopStep> once{{0, 0, 1}, {2, 0, 1}, {3, 0, 1}, {1, 1, 0}};
  EXPECT_EQ(search.find(1), once);
  const std::vector<LoopStep> back{{1, 0, 1}, {3, 1, 0}, {2, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(search.find(-1), back);
  EXPECT_EQ(search.find(3).value().size(), 12U);
}

TEST(LoopSearch, FindsNothingWhereThereIsNothing) {
  const Steps steps;
  const std::vector<PlacedSimplex<1>> open{{0, 1, 0}, {1, 2, 0}, {2, 3, 0}};
  LoopSearch<1, Steps> search(open, 4, steps);
  EXPECT_FALSE(search.find(1).has_value());
  LoopSearch<1, Steps> bounded(circle, 4, steps);
  EXPECT_FALSE(bounded.find(1000, 100).has_value());
}

TEST(LoopSearch, ElementsAreThoseAfterTheLabels) {
  const PlacedSimplex<2> simplex{3, 5, 9, 7, 8};
  EXPECT_EQ(element_at<2>(simplex, 0), 0U);
  EXPECT_EQ(element_at<2>(simplex, 1), 7U);
  EXPECT_EQ(element_at<2>(simplex, 2), 8U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
