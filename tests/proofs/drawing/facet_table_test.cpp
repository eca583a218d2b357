#include "proofs/drawing/facet_table.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(FacetTable, PutsTheSidesOfAFacetTogether) {
  const std::vector<std::uint32_t> triangles{0, 1, 2, 2, 3, 1};
  const FacetTable facets(triangles, 3);
  ASSERT_EQ(facets.sides().size(), 6U);
  std::size_t shared = 0;
  for (std::size_t at = 0; at < facets.sides().size(); ++at) {
    if (!facets.is_same_as_before(at)) continue;
    ++shared;
    const auto vertices = facets.vertices(at);
    EXPECT_EQ(std::vector<std::uint32_t>(vertices.begin(), vertices.end()), (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(facets.sides()[at - 1].simplex, 0U);
    EXPECT_EQ(facets.sides()[at - 1].without, 0U);
    EXPECT_EQ(facets.sides()[at].simplex, 1U);
    EXPECT_EQ(facets.sides()[at].without, 1U);
  }
  EXPECT_EQ(shared, 1U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
