#include "proofs/drawing/formats/cell_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(CellData, MeasuresAreInTheOrderOfTheDrawing) {
  DrawingOptions glued;
  glued.copies = DrawingCopies::glued;
  const Drawing drawing = drawing_of(test::torus_certificate(), glued);
  const auto measures = named_measures(drawing);
  ASSERT_EQ(measures.size(), 4U);
  EXPECT_EQ(measures[1].name, "thickness");
  ASSERT_EQ(measures[1].values.size(), drawing.simplex_count());
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex)
    EXPECT_EQ(measures[1].values[simplex], drawing.measures.thickness[drawing.positions[simplex]]);
  EXPECT_EQ(named_measures(drawing_of(test::hexagon_certificate(), {})).size(), 3U);
}

TEST(CellData, PointsOfThePlaneAreInSpace) {
  const Drawing drawing = drawing_of(test::hexagon_certificate(), {});
  EXPECT_EQ(space_point(drawing, 1), (std::array<double, 3>{2, 0, 0}));
  const Drawing sphere = drawing_of(test::drawn_certificates().at("sphere-2"), {});
  EXPECT_EQ(space_point(sphere, 1)[2], sphere.coordinates[5]);
}

TEST(CellData, LiftsAreListedWhereThereAreSome) {
  EXPECT_TRUE(lift_lines(drawing_of(test::hexagon_certificate(), {})).empty());
  const auto lines = lift_lines(drawing_of(test::torus_certificate(), {}));
  EXPECT_NE(std::find(lines.begin(), lines.end(), "lift 0: 0 0"), lines.end());
  EXPECT_EQ(comment_lines("# ", "origin", {"a", "b"}), "# origin\n# a\n# b\n");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
