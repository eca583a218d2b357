#include "kernel/manifold/submanifold/cover_check.hpp"

#include "kernel/sample/submanifold_net.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Charts that cover them.
struct TwoSpheres {
  ZeroSet zero_set = two_spheres();
  std::vector<TangentChart> charts = submanifold_net<2>(zero_set, ratio(1, 30), 1, no_progress()).charts.charts;
};

TEST(CheckCover, finds_every_part_of_a_manifold_that_charts_leave_out) {
  const TwoSpheres all;
  const auto whole = check_cover(all.zero_set, all.charts, no_progress());
  EXPECT_TRUE(whole.open.empty());
  EXPECT_GT(whole.parts, 1000U);

  // Without one component.
  std::vector<TangentChart> some;
  for (const TangentChart& chart : all.charts) {
    if (chart.data().centre[0] < Rational(0)) some.push_back(chart);
  }
  ASSERT_LT(some.size(), all.charts.size());
  const auto without = check_cover(all.zero_set, some, no_progress());
  ASSERT_FALSE(without.open.empty());
  for (const BoxPart& part : without.open) {
    EXPECT_LT(part.lower[0], 1.9);
    EXPECT_GT(part.upper[0], 1.1);
  }

  // With a hole.
  std::vector<TangentChart> pierced;
  for (const TangentChart& chart : all.charts) {
    if (chart.data().centre[0] < ratio(-5, 4) || chart.data().centre[0] > Rational(0)) pierced.push_back(chart);
  }
  const auto hole = check_cover(all.zero_set, pierced, no_progress());
  ASSERT_FALSE(hole.open.empty());
  for (const BoxPart& part : hole.open) EXPECT_LT(part.lower[0], -0.9);
}

TEST(CheckCover, is_not_deceived_by_cylinders_without_their_sides) {
  // Patches that are too small leave gaps between them.
  TwoSpheres all;
  for (TangentChart& chart : all.charts) chart.set_size(ratio(1, 50), chart.data().height);
  EXPECT_FALSE(check_cover(all.zero_set, all.charts, no_progress()).open.empty());
}

TEST(CheckCover, needs_no_charts_where_there_are_no_zeros) {
  const ZeroSet none =
      zero_set("none", {"x", "y", "z"}, {"x^2 + y^2 + z^2 + 1/100"}, std::vector<Rational>(3, Rational(1)));
  EXPECT_TRUE(check_cover(none, {}, no_progress()).open.empty());
  const ZeroSet point = zero_set("point", {"x", "y", "z"}, {"x^2 + y^2 + z^2"}, std::vector<Rational>(3, Rational(1)));
  EXPECT_FALSE(check_cover(point, {}, no_progress()).open.empty());
}

TEST(CheckCover, combines_equations) {
  const ZeroSet torus = clifford_torus();
  const auto net = submanifold_net<2>(torus, ratio(1, 10), 1, no_progress());
  EXPECT_TRUE(check_cover(torus, net.charts.charts, no_progress()).open.empty());
  // The same equations, added up: the patches are the same, and the work is about the same.
  const ZeroSet other = zero_set("clifford-torus", {"a", "b", "c", "d"}, {"a^2 + b^2 - 1", "a^2 + b^2 + c^2 + d^2 - 2"},
                                 std::vector<Rational>(4, ratio(3, 2)));
  const auto again = submanifold_net<2>(other, ratio(1, 10), 1, no_progress());
  EXPECT_LE(again.parts, 4 * net.parts);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
