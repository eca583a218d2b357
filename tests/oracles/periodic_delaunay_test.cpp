// CGAL's periodic Delaunay triangulations against the certified complex, as sets of lifted labels.

#include "tests/oracles/certified_run.hpp"
#include "tests/oracles/cgal_delaunay.hpp"
#include "tests/oracles/twins.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// CGAL's complex of the perturbed points is ours. Neither a flip, which counting at the facets accepts, nor a moved
/// point gets through.
template <int m>
void expect_same_complex(const CertifiedRun<m>& run) {
  expect_rounding_is_harmless<m>(run);
  const Doubles<m> points = run.result.points.approximate_all();
  const Complex<m> theirs = CgalTorus<m>(points).complex();
  EXPECT_EQ(disagreement<m>(run.simplices(), theirs), "");

  const Complex<m> flipped = with_one_flip<m>(run.simplices());
  EXPECT_TRUE(StarComplex<m>(flipped, std::vector<bool>(run.atlas.size(), true)).combinatorial_failures().empty());
  EXPECT_NE(disagreement<m>(flipped, theirs), "");
  const auto moved =
      with_one_point_in_a_ball<m>(points, run.atlas.metric(), run.simplices(), third_of_radius<m>(run.atlas));
  EXPECT_NE(disagreement<m>(run.simplices(), CgalTorus<m>(moved).complex()), "");
}

TEST(PeriodicDelaunay, square_torus_1_24_in_theory_mode) {
  expect_same_complex<2>(certified_run<2>("torus-2", 24, RunMode::theory));
}
TEST(PeriodicDelaunay, square_torus_1_24_in_measured_mode) {
  expect_same_complex<2>(certified_run<2>("torus-2", 24, RunMode::measured));
}
TEST(PeriodicDelaunay, square_torus_1_60_in_theory_mode) {
  expect_same_complex<2>(certified_run<2>("torus-2", 60, RunMode::theory));
}
TEST(PeriodicDelaunay, square_torus_1_60_in_measured_mode) {
  expect_same_complex<2>(certified_run<2>("torus-2", 60, RunMode::measured));
}
TEST(PeriodicDelaunay, cubic_torus_1_24_in_theory_mode) {
  expect_same_complex<3>(certified_run<3>("torus-3", 24, RunMode::theory));
}
TEST(PeriodicDelaunay, cubic_torus_1_24_in_measured_mode) {
  expect_same_complex<3>(certified_run<3>("torus-3", 24, RunMode::measured));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
