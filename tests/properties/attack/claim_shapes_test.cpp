#include "properties/attack/claim_shapes.hpp"

#include <gtest/gtest.h>

#include "properties/attack/claim_library.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Claim parsed(const std::string& text) { return parse_claim(text, "a.toml", full_vocabulary(), all_signatures()); }

TEST(ClaimShapes, of_a_class_are_those_of_the_class) {
  const Claim claim = parsed("name = 'n'\ninstance = 'simplex'\n[[show]]\nclaim = 'k >= 1'\n");
  EXPECT_EQ(usual_shapes(claim), instance_class("simplex").shapes());
  EXPECT_TRUE(has_shape(claim, {2, 3}));
  EXPECT_FALSE(has_shape(claim, {3, 2}));
}

TEST(ClaimShapes, of_points_are_those_that_the_claim_allows) {
  const Claim claim = parsed(
      "name = 'n'\ninstance = 'point-set'\n[points]\nnumber = '4 .. 5'\ndimension = '1 .. 2'\nbox = '[0, 1]'\n"
      "[[show]]\nclaim = 'n >= 1'\n");
  EXPECT_EQ(usual_shapes(claim), (std::vector<Shape>{{3, 1}, {3, 2}, {4, 1}, {4, 2}}));
  EXPECT_TRUE(has_shape(claim, {4, 2}));
  EXPECT_FALSE(has_shape(claim, {2, 2})) << "three points are too few";
  EXPECT_FALSE(has_shape(claim, {3, 3}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
