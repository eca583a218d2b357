#include "kernel/topology/edge_contraction.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/topology/components.hpp"
#include "kernel/topology/homology.hpp"
#include "kernel/topology/orientation.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::vector<std::string> groups_of(Dimension dimension, const std::vector<std::uint32_t>& labels) {
  std::vector<std::string> result;
  for (const AbelianGroup& group : homology(PureComplex(dimension, labels))) result.push_back(group_text(group));
  return result;
}

/// A torus ℤᵐ/(n ℤ)ᵐ by Kuhn's simplices in each cube.
std::vector<std::uint32_t> cubical_torus(std::size_t m, std::uint32_t n) {
  std::vector<std::uint32_t> labels;
  std::uint32_t cubes = 1;
  for (std::size_t axis = 0; axis < m; ++axis) cubes *= n;
  for (std::uint32_t cube = 0; cube < cubes; ++cube) {
    std::vector<std::size_t> order;
    for (std::size_t axis = 0; axis < m; ++axis) order.push_back(axis);
    do {
      std::vector<std::uint32_t> place;
      for (std::uint32_t rest = cube, axis = 0; axis < m; ++axis, rest /= n) place.push_back(rest % n);
      const auto label_of = [&place, n] {
        std::uint32_t label = 0;
        for (std::size_t axis = place.size(); axis-- > 0;) label = label * n + place[axis] % n;
        return label;
      };
      labels.push_back(label_of());
      for (const std::size_t axis : order) {
        ++place[axis];
        labels.push_back(label_of());
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return labels;
}

TEST(EdgeContraction, LeavesTheHomologyOfTori) {
  for (const std::size_t m : {2U, 3U}) {
    const Dimension dimension(static_cast<int>(m));
    const auto labels = cubical_torus(m, 6);
    const ContractedComplex less = contract_edges(dimension, labels);
    EXPECT_GT(less.contractions, 0U);
    EXPECT_LT(less.simplices.size(), labels.size() / 4);
    EXPECT_EQ(groups_of(dimension, less.simplices), groups_of(dimension, labels));
    const PureComplex complex(dimension, less.simplices);
    EXPECT_EQ(complex.count(static_cast<int>(m)) * (m + 1), less.simplices.size());
    EXPECT_EQ(facet_degrees(complex).one + facet_degrees(complex).more, 0U);
    EXPECT_EQ(complex.euler_characteristic(), 0);
  }
}

TEST(EdgeContraction, OfASurfaceEndsWhereNoEdgeCanGo) {
  // Of tori there are 21 irreducible triangulations, with 7 to 10 vertices (Lawrencenko).
  const ContractedComplex less = contract_edges(Dimension(2), cubical_torus(2, 8));
  const PureComplex complex(Dimension(2), less.simplices);
  EXPECT_GE(complex.count(0), 7U);
  EXPECT_LE(complex.count(0), 10U);
  EXPECT_GT(less.refused, 0U);
  // Nothing is left to be done.
  EXPECT_EQ(contract_edges(Dimension(2), less.simplices).contractions, 0U);
}

TEST(EdgeContraction, OfASphereEndsWithTheBoundaryOfASimplex) {
  // The octahedron.
  const std::vector<std::uint32_t> labels{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 1, 4, 5, 1, 2, 5, 2, 3, 5, 3, 4, 5, 1, 4};
  const ContractedComplex less = contract_edges(Dimension(2), labels);
  EXPECT_EQ(less.contractions, 2U);
  EXPECT_EQ(less.simplices.size(), 12U);
  EXPECT_EQ(groups_of(Dimension(2), less.simplices), (std::vector<std::string>{"Z", "0", "Z"}));
}

TEST(EdgeContraction, TheSmallestTorusAndProjectivePlaneStayAsTheyAre) {
  // Möbius' torus: every two of its seven vertices are joined, so every contraction would break the link condition.
  std::vector<std::uint32_t> torus;
  for (std::uint32_t k = 0; k < 7; ++k) {
    for (const std::uint32_t label : {k, (k + 1) % 7, (k + 3) % 7, k, (k + 2) % 7, (k + 3) % 7}) torus.push_back(label);
  }
  const ContractedComplex same = contract_edges(Dimension(2), torus);
  EXPECT_EQ(same.contractions, 0U);
  EXPECT_EQ(same.simplices.size(), torus.size());
  EXPECT_GT(same.refused, 0U);
  const std::vector<std::uint32_t> plane{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 1, 5,
                                         1, 2, 4, 2, 3, 5, 1, 3, 4, 2, 4, 5, 1, 3, 5};
  EXPECT_EQ(contract_edges(Dimension(2), plane).contractions, 0U);
}

TEST(EdgeContraction, DependsOnTheComplexOnly) {
  auto labels = cubical_torus(3, 4);
  const ContractedComplex once = contract_edges(Dimension(3), labels);
  EXPECT_EQ(contract_edges(Dimension(3), labels).simplices, once.simplices);
  for (std::size_t at = 0; at < labels.size(); at += 4) std::swap(labels[at], labels[at + 3]);
  EXPECT_EQ(contract_edges(Dimension(3), labels).simplices, once.simplices);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
