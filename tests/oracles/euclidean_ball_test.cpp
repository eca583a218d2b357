// The Euclidean algorithm: the stars of interior labels of a finite net of a ball, against CGAL's Delaunay
// triangulation of all its points.

#include "tests/oracles/certified_run.hpp"
#include "tests/oracles/cgal_delaunay.hpp"
#include "tests/oracles/twins.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
Complex<m> stars_of_interior_labels(const FlatAtlas<m>& atlas, const Doubles<m>& points) {
  std::vector<Lift<m>> names;
  for (std::uint32_t index = 0; index < points.size(); ++index) names.push_back({index, {}});
  return cgal_complex<m>(points, names, [&atlas](const LiftedSimplex<m>& simplex) {
    return std::any_of(simplex.begin(), simplex.end(),
                       [&atlas](const Lift<m>& lift) { return atlas.is_interior(Label(lift.index)); });
  });
}

template <int m>
void expect_same_stars(const std::string& manifold, int n, RunMode mode) {
  const auto run = certified_run<m>(manifold, n, mode);
  expect_rounding_is_harmless<m>(run);
  const auto points = run.result.points.approximate_all();
  ASSERT_FALSE(run.simplices().empty());
  const Complex<m> theirs = stars_of_interior_labels<m>(run.atlas, points);
  EXPECT_EQ(disagreement<m>(run.simplices(), theirs), "");

  EXPECT_NE(disagreement<m>(with_one_flip<m>(run.simplices()), theirs), "");
  const auto moved =
      with_one_point_in_a_ball<m>(points, run.atlas.metric(), run.simplices(), third_of_radius<m>(run.atlas));
  EXPECT_NE(disagreement<m>(run.simplices(), stars_of_interior_labels<m>(run.atlas, moved)), "");
}

TEST(EuclideanBall, disk_in_theory_mode) { expect_same_stars<2>("disk", 24, RunMode::theory); }
TEST(EuclideanBall, disk_in_measured_mode) { expect_same_stars<2>("disk", 24, RunMode::measured); }
TEST(EuclideanBall, ball_in_theory_mode) { expect_same_stars<3>("ball-3", 11, RunMode::theory); }
TEST(EuclideanBall, ball_in_measured_mode) { expect_same_stars<3>("ball-3", 11, RunMode::measured); }

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
