#include "properties/attack/witness_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(WitnessPoints, of_a_simplex_are_its_vertices) {
  const auto sets = drawn_sets({"c", "d", "", "simplex", test::triangle_bindings(Rational(1) / Rational(4), 1)});
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(sets[0].name, "s");
  EXPECT_TRUE(sets[0].is_simplex);
  EXPECT_EQ(sets[0].points, (std::vector<std::vector<double>>{{0, 0}, {1, 0}, {0.25, 1}}));
}

TEST(WitnessPoints, of_squared_edges_have_these_distances) {
  SymmetricMatrix<Rational> squared(4);
  const long edges[3][3] = {{9, 0, 0}, {16, 25, 0}, {17, 18, 19}};
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) squared(i, j) = Rational(edges[i - 1][j]);
  }
  Bindings bindings{{"s", std::make_shared<SimplexObject>(squared)}, {"k", 3L}, {"m", 3L}};
  const auto sets = drawn_sets({"c", "d", "", "simplex", bindings});
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_TRUE(sets[0].is_simplex);
  ASSERT_EQ(sets[0].points.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum += std::pow(sets[0].points[i][axis] - sets[0].points[j][axis], 2);
      EXPECT_NEAR(sum, static_cast<double>(edges[i - 1][j]), 1e-12) << i << " " << j;
    }
  }
}

TEST(WitnessPoints, beyond_the_range_of_doubles_are_left_out) {
  const Rational huge = Rational::power_of_two(3000);
  EXPECT_TRUE(drawn_sets({"c", "d", "", "simplex", test::triangle_bindings(huge, 1)}).empty());
}

TEST(WitnessPoints, are_there_for_every_class_that_has_points) {
  for (const InstanceClass* each : instance_classes()) {
    RandomChoices choices(1, 2, 3);
    const auto instance = each->draw(each->shapes().front(), {}, NoLimits(), choices);
    if (!instance) continue;
    const auto sets = drawn_sets({"c", "d", "", each->name(), instance->bindings});
    for (const DrawnSet& set : sets) {
      ASSERT_FALSE(set.points.empty()) << each->name();
      for (const auto& point : set.points) EXPECT_EQ(point.size(), set.points.front().size()) << each->name();
    }
    // A run is told by its parameters, not by points.
    EXPECT_EQ(sets.empty(), each->name() == "run") << each->name();
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
