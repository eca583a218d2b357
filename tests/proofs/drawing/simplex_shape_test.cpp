#include "proofs/drawing/simplex_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delcert {
namespace DELCERT_THIS_FILE {

/// A triangle with legs 3 and 4.
SquaredEdges right_triangle() {
  SquaredEdges squares{};
  squares[0][1] = squares[1][0] = 9;
  squares[0][2] = squares[2][0] = 16;
  squares[1][2] = squares[2][1] = 25;
  return squares;
}

TEST(ApproximateShape, OfARightTriangle) {
  const ApproximateShape shape = approximate_shape(2, right_triangle());
  EXPECT_NEAR(shape.circumradius, 2.5, 1e-14);
  EXPECT_NEAR(shape.altitudes[0], 12.0 / 5, 1e-14);
  EXPECT_NEAR(shape.altitudes[1], 3, 1e-14);
  EXPECT_NEAR(shape.altitudes[2], 4, 1e-14);
  EXPECT_NEAR(shape.thickness, 12.0 / 5 / (2 * 5), 1e-14);
  // The circumcentre is the middle of the hypotenuse.
  EXPECT_NEAR(shape.centre[0], 0, 1e-14);
  EXPECT_NEAR(shape.centre[1], 0.5, 1e-14);
  EXPECT_NEAR(shape.centre[2], 0.5, 1e-14);
}

TEST(ApproximateShape, OfRegularSimplices) {
  SquaredEdges squares{};
  for (auto& row : squares) row.fill(1);
  for (std::size_t k = 0; k < squares.size(); ++k) squares[k][k] = 0;
  for (std::size_t m = 1; m <= 4; ++m) {
    const double d = static_cast<double>(m);
    const ApproximateShape shape = approximate_shape(m, squares);
    EXPECT_NEAR(shape.circumradius, std::sqrt(d / (2 * (d + 1))), 1e-14);
    EXPECT_NEAR(shape.altitudes[m], std::sqrt((d + 1) / (2 * d)), 1e-14);
    EXPECT_NEAR(shape.centre[0], 1 / (d + 1), 1e-14);
  }
}

TEST(ApproximateShape, OfADegenerateOneIsNone) {
  SquaredEdges squares = right_triangle();
  squares[1][2] = squares[2][1] = 49;
  EXPECT_TRUE(std::isnan(approximate_shape(2, squares).thickness) || approximate_shape(2, squares).thickness < 1e-6);
  SquaredEdges points{};
  EXPECT_TRUE(std::isnan(approximate_shape(2, points).circumradius));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
