#include "kernel/topology/orientation.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/topology/known_complexes.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

PureComplex pure(const LabelComplex& complex) { return {Dimension(complex.dimension), complex.labels}; }

TEST(Orientation, of_closed_manifolds) {
  for (const KnownComplex& known : known_complexes()) {
    if (!known.closed_manifold) continue;
    const PureComplex complex = pure(known.complex);
    EXPECT_EQ(is_orientable(complex), std::optional(known.orientable)) << known.name;
    EXPECT_EQ(facet_degrees(complex).one, 0U) << known.name;
    EXPECT_EQ(facet_degrees(complex).more, 0U) << known.name;
  }
}

TEST(Orientation, of_one_component_that_has_none) {
  EXPECT_EQ(is_orientable(pure(disjoint_union(seven_vertex_torus(), six_vertex_projective_plane()))), false);
  EXPECT_EQ(is_orientable(pure(disjoint_union(six_vertex_projective_plane(), seven_vertex_torus()))), false);
}

TEST(Orientation, of_manifolds_with_boundary) {
  const PureComplex disc = pure(without_simplex(smallest_sphere(2), 0));
  EXPECT_EQ(is_orientable(disc), true);
  EXPECT_EQ(facet_degrees(disc).one, 3U);
  const PureComplex moebius_band = pure(without_simplex(six_vertex_projective_plane(), 0));
  EXPECT_EQ(is_orientable(moebius_band), false);
  EXPECT_EQ(facet_degrees(moebius_band).one, 3U);
  EXPECT_EQ(facet_degrees(moebius_band).more, 0U);
}

TEST(Orientation, of_three_sheets_is_no_question) {
  const PureComplex three(Dimension(2), {0, 1, 2, 0, 1, 3, 0, 1, 4});
  EXPECT_EQ(is_orientable(three), std::nullopt);
  EXPECT_EQ(facet_degrees(three).more, 1U);
  EXPECT_EQ(is_orientable(pure(glued_polygon("aaa"))), std::nullopt);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
