#include "properties/instances/net_forbidden.hpp"

#include <gtest/gtest.h>

#include "kernel/simplex/faces.hpp"
#include "kernel/simplex/forbidden_configuration.hpp"
#include "properties/instances/choices.hpp"
#include "tests/properties/instances/square_net.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// By all subsets, without any filter.
template <int m>
bool has_forbidden_exhaustively(const std::vector<Vector<Rational, m>>& points, const NetForbiddenParameters& p) {
  const ForbiddenConfigurationParameters<Rational> squares{square(p.flake_parameter), square(p.sampling_radius),
                                                           square(p.protection)};
  for (std::size_t count = 3; count <= m + 2; ++count) {
    for (Faces faces(points.size(), count); faces.has_face(); faces.advance()) {
      std::vector<std::vector<Rational>> vertices;
      for (const std::size_t at : faces.vertices()) vertices.emplace_back(points[at].begin(), points[at].end());
      if (is_proved(is_forbidden_configuration(edge_gram_from_points(vertices), m, squares))) return true;
    }
  }
  return false;
}

template <int m>
std::pair<int, int> compare(std::size_t count, int instances) {
  std::pair<int, int> seen{0, 0};
  for (int number = 0; number < instances; ++number) {
    RandomChoices choices(3, m, static_cast<std::uint32_t>(number));
    const Rational flake = Rational::power_of_two(-choices.between(1, 8));
    const NetForbiddenParameters parameters{flake, Rational(1) + choices.fraction(3),
                                            Rational::power_of_two(-choices.between(3, 12))};
    std::vector<Vector<Rational, m>> points(count);
    for (auto& point : points) {
      for (Rational& coordinate : point) coordinate = Rational(2) * choices.symmetric(5);
    }
    const auto found = find_forbidden_configuration<m>(points, parameters);
    EXPECT_EQ(found.has_value(), has_forbidden_exhaustively<m>(points, parameters)) << number;
    (found ? seen.first : seen.second) += 1;
  }
  return seen;
}

TEST(NetForbidden, finds_exactly_what_all_subsets_have) {
  const auto plane = compare<2>(7, 60);
  EXPECT_GT(plane.first, 5);
  EXPECT_GT(plane.second, 5);
  const auto space = compare<3>(7, 40);
  EXPECT_GT(space.first, 3);
  EXPECT_GT(space.second, 3);
}

TEST(NetForbidden, finds_cospherical_points_whatever_the_parameters) {
  const Rational smallest = Rational::power_of_two(-60);
  const auto found = find_forbidden_configuration<2>(square_vectors(2), {smallest, Rational(1), Rational(0)});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->size(), 4U);
  // Circumradius √2/2 of the smallest squares.
  EXPECT_FALSE(
      find_forbidden_configuration<2>(square_vectors(2), {smallest, Rational(Integer(7), Integer(10)), Rational(0)})
          .has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
