#include "kernel/topology/components.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/topology/known_complexes.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(Components, are_as_many_as_homology_says) {
  for (const KnownComplex& known : known_complexes()) {
    const std::size_t components =
        component_count(PureComplex(Dimension(known.complex.dimension), known.complex.labels));
    EXPECT_EQ(known.homology[0], components == 1 ? "Z" : "Z^" + std::to_string(components)) << known.name;
  }
}

TEST(Components, fall_apart_without_a_simplex) {
  EXPECT_EQ(component_count(PureComplex(Dimension(1), {0, 1, 1, 2, 2, 3})), 1U);
  EXPECT_EQ(component_count(PureComplex(Dimension(1), {0, 1, 2, 3})), 2U);
  EXPECT_EQ(component_count(PureComplex(Dimension(0), {5, 6, 7})), 3U);
  EXPECT_EQ(component_count(PureComplex(Dimension(3), {})), 0U);
}

TEST(Components, are_named_by_their_least_labels) {
  using Edges = std::vector<std::array<std::uint32_t, 2>>;
  EXPECT_EQ(component_of_labels(6, Edges{{4, 5}, {1, 3}, {3, 4}}), (std::vector<std::uint32_t>{0, 1, 2, 1, 1, 1}));
  EXPECT_EQ(component_of_labels(6, Edges{{4, 5}, {1, 3}}), (std::vector<std::uint32_t>{0, 1, 2, 1, 4, 4}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
