#include "properties/instances/random_simplex.hpp"

#include <algorithm>

#include "kernel/simplex/altitude.hpp"
#include "kernel/simplex/realisability.hpp"
#include "tests/properties/instances/class_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(RandomSimplex, IsNonDegenerateAndOfItsShape) {
  for (const Shape& shape : simplex_shapes()) {
    for (std::uint32_t number = 0; number < 10; ++number) {
      RandomChoices choices(3, static_cast<std::uint32_t>(10 * shape.k + shape.m), number);
      const auto points = random_simplex(shape, choices);
      if (!points) continue;
      EXPECT_EQ(points->size(), static_cast<std::size_t>(shape.k) + 1);
      EXPECT_EQ(points->front().size(), static_cast<std::size_t>(shape.m));
      EXPECT_EQ(is_non_degenerate(edge_gram_from_points(*points)), Verdict::proved);
    }
  }
}

TEST(RandomSimplex, HasSixShapesOfEachKindUpToSix) {
  const auto shapes = simplex_shapes();
  EXPECT_EQ(shapes.size(), 24U);
  EXPECT_EQ(shapes.front(), (Shape{1, 1}));
  EXPECT_EQ(shapes.back(), (Shape{6, 9}));
}

TEST(RandomSimplex, TheHighestVertexComesFirst) {
  for (std::uint32_t number = 0; number < 50; ++number) {
    // Fat ones, for which doubles are good enough.
    RandomChoices choices(5, 1, number);
    SimplexObject::Points points;
    for (int i = 0; i < 4; ++i) {
      points.emplace_back();
      for (int axis = 0; axis < 4; ++axis) points.back().push_back(choices.symmetric(10));
    }
    auto ordered = points;
    put_high_vertex_first(ordered);
    EXPECT_TRUE(std::is_permutation(points.begin(), points.end(), ordered.begin()));
    const auto gram = edge_gram_from_points(ordered);
    for (std::size_t p = 1; p < 4; ++p) EXPECT_LE(*squared_altitude(gram, p), *squared_altitude(gram, 0));
  }
}

TEST(RandomSimplex, ThinOnesAreNoticed) {
  const auto triangle = [](long exponent) {
    return SimplexObject(
        {{Rational(0), Rational(0)}, {Rational(1), Rational(0)}, {Rational(0), Rational::power_of_two(exponent)}});
  };
  EXPECT_TRUE(traits_of(triangle(-60)).contains(Trait::nearly_degenerate));
  EXPECT_FALSE(traits_of(triangle(-3)).contains(Trait::nearly_degenerate));
}

TEST(RandomSimplex, SimplerPointsKeepWhatMustBeLeft) {
  const SimplexObject::Points points{{Rational(3), Rational(5)}, {Rational(1) / Rational(3), Rational(7)}};
  const auto simpler = simpler_points(points, 2, 2);
  EXPECT_FALSE(simpler.empty());
  for (const auto& each : simpler) {
    EXPECT_EQ(each.size(), 2U);
    EXPECT_EQ(each.front().size(), 2U);
  }
  EXPECT_TRUE(std::any_of(simpler.begin(), simpler.end(), [](const auto& each) {
    return each[0] == std::vector<Rational>{Rational(0), Rational(0)};
  }));
}

TEST(RandomSimplex, SimplerNumbersHaveTheSameSign) {
  EXPECT_TRUE(simpler_numbers(Rational(0)).empty());
  for (const Rational& each : simpler_numbers(Rational(-22) / Rational(7))) EXPECT_LT(each, Rational(0));
}

TEST(RandomSimplex, SimplerNumbersArePowersOfOneHalfAndFewDigits) {
  const auto offered = [](const Rational& number, const Rational& simpler) {
    const auto numbers = simpler_numbers(number);
    return std::count(numbers.begin(), numbers.end(), simpler);
  };
  const Rational tenth = Rational(1) / Rational(10);
  for (const Rational& sign : {Rational(1), Rational(-1)}) {
    for (const long halvings : {0L, 1L, 2L, 3L, 4L}) {
      EXPECT_EQ(offered(sign * tenth, sign * Rational::power_of_two(-halvings)), 1) << halvings;
    }
    // No power that is further from 1 than the number.
    EXPECT_EQ(offered(sign * tenth, sign * Rational::power_of_two(-5)), 0);
    EXPECT_EQ(offered(sign * Rational(5), sign * Rational::power_of_two(-1)), 0);
    EXPECT_EQ(offered(sign * Rational(5), sign * Rational(4)), 1);
  }
  EXPECT_EQ(offered(tenth, Rational(3) / Rational(32)), 1);
  EXPECT_EQ(offered(Rational::power_of_two(-200), Rational::power_of_two(-128)), 1);
  // Nothing is simpler than itself.
  for (const Rational& number : {Rational(1), Rational(-1), Rational(1) / Rational(4), Rational(4), tenth}) {
    EXPECT_EQ(offered(number, number), 0);
  }
  EXPECT_TRUE(simpler_numbers(Rational(1)).empty());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
