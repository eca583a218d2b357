// CGAL's periodic triangulations know the square and the cube only. For another lattice its triangulation of the plane
// takes 5 × 5 copies of the points; the triangles at the copy in the middle are compared.

#include "tests/oracles/certified_run.hpp"
#include "tests/oracles/cgal_delaunay.hpp"
#include "tests/oracles/twins.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

constexpr std::int32_t copies_on_each_side = 2;

/// Cartesian coordinates of lattice coordinates in the basis (1, 0), (2/5, 19/20) of examples/manifolds.
Vector<double, 2> cartesian(const Vector<double, 2>& x) { return {x[0] + 2 * x[1] / 5, 19 * x[1] / 20}; }

Complex<2> complex_of_middle_copy(const Doubles<2>& points) {
  Doubles<2> positions;
  std::vector<Lift<2>> names;
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    for (std::int32_t a = -copies_on_each_side; a <= copies_on_each_side; ++a) {
      for (std::int32_t b = -copies_on_each_side; b <= copies_on_each_side; ++b) {
        positions.push_back(cartesian({points[index][0] + a, points[index][1] + b}));
        names.push_back({index, {a, b}});
      }
    }
  }
  return cgal_complex<2>(positions, names, [](const LiftedSimplex<2>& simplex) {
    return std::any_of(simplex.begin(), simplex.end(), [](const Lift<2>& lift) { return lift.shift == Shift<2>{}; });
  });
}

void expect_same_complex(RunMode mode) {
  const auto run = certified_run<2>("torus-2-skewed", 24, mode);
  expect_rounding_is_harmless<2>(run);
  const auto points = run.result.points.approximate_all();
  const Complex<2> theirs = complex_of_middle_copy(points);
  EXPECT_EQ(disagreement<2>(run.simplices(), theirs), "");

  EXPECT_NE(disagreement<2>(with_one_flip<2>(run.simplices()), theirs), "");
  const auto moved =
      with_one_point_in_a_ball<2>(points, run.atlas.metric(), run.simplices(), third_of_radius<2>(run.atlas));
  EXPECT_NE(disagreement<2>(run.simplices(), complex_of_middle_copy(moved)), "");
}

TEST(CopiesOfASkewedTorus, have_the_certified_complex_in_theory_mode) { expect_same_complex(RunMode::theory); }
TEST(CopiesOfASkewedTorus, have_the_certified_complex_in_measured_mode) { expect_same_complex(RunMode::measured); }

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
