#include "proofs/drawing/formats/isomorphism_signature.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace delcert {
namespace DELCERT_THIS_FILE {

LabelComplex sphere_with(std::uint32_t dimension, const std::vector<std::uint32_t>& names) {
  LabelComplex result;
  result.dimension = dimension;
  for (std::uint32_t without = 0; without < dimension + 2; ++without) {
    std::vector<std::uint32_t> simplex;
    for (std::uint32_t k = 0; k < dimension + 2; ++k) {
      if (k != without) simplex.push_back(names[k]);
    }
    std::sort(simplex.begin(), simplex.end());
    result.simplices.insert(result.simplices.end(), simplex.begin(), simplex.end());
  }
  return result;
}

// What Regina 7.3 says of the boundary of a simplex; tests/receivers compares with Regina itself.
TEST(IsomorphismSignature, OfBoundariesOfSimplices) {
  EXPECT_EQ(isomorphism_signature(Gluings(sphere_with(2, {0, 1, 2, 3}))), "evQcddcfb");
  EXPECT_EQ(isomorphism_signature(Gluings(sphere_with(3, {0, 1, 2, 3, 4}))), "fvPQccdedeegovcfb");
  EXPECT_EQ(isomorphism_signature(Gluings(sphere_with(4, {0, 1, 2, 3, 4, 5}))), "gvLQQQcdefdefeffya2aqbPbgaoavacafaba");
}

TEST(IsomorphismSignature, DoesNotDependOnNames) {
  // The octahedron, and the octahedron under other names; then two triangles are exchanged for another diagonal.
  LabelComplex octahedron;
  octahedron.dimension = 2;
  octahedron.simplices = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 1, 4, 1, 2, 5, 2, 3, 5, 3, 4, 5, 1, 4, 5};
  const std::string text = isomorphism_signature(Gluings(octahedron));
  LabelComplex renamed = octahedron;
  const std::vector<std::uint32_t> names{3, 5, 0, 2, 4, 1};
  for (std::uint32_t& vertex : renamed.simplices) vertex = names[vertex];
  for (std::size_t at = 0; at < renamed.simplices.size(); at += 3)
    std::sort(renamed.simplices.begin() + static_cast<std::ptrdiff_t>(at),
              renamed.simplices.begin() + static_cast<std::ptrdiff_t>(at + 3));
  EXPECT_EQ(isomorphism_signature(Gluings(renamed)), text);
  LabelComplex other = octahedron;
  // 0 1 2 and 0 2 3 become 0 1 3 and 1 2 3.
  other.simplices = {0, 1, 3, 1, 2, 3, 0, 3, 4, 0, 1, 4, 1, 2, 5, 2, 3, 5, 3, 4, 5, 1, 4, 5};
  EXPECT_NE(isomorphism_signature(Gluings(other)), text);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
