// CGAL's periodic Delaunay triangulations against the certified complex, as sets of lifted labels.

#include "tests/oracles/certified_run.hpp"
#include "tests/oracles/cgal_delaunay.hpp"
#include "tests/oracles/twins.hpp"

namespace delcert::test {
namespace {

/// A flip that counting at the facets accepts, and a moved point, must both be noticed.
template <int m>
void expect_twins_noticed(const CertifiedRun<m>& run) {
  const Complex<m> flipped = with_one_flip<m>(run.simplices());
  EXPECT_NE(flipped, run.simplices());
  EXPECT_TRUE(StarComplex<m>(flipped, std::vector<bool>(run.atlas.size(), true)).combinatorial_failures().empty());
  EXPECT_NE(CgalTorus<m>(run.result.points.approximate_all()).complex(), flipped);

  const double two_radii = 2 * approximate_double(run.atlas.sampling_radius());
  const auto moved = with_one_point_moved<m>(run.result.points.approximate_all(), run.atlas.size() / 2, two_radii);
  EXPECT_NE(CgalTorus<m>(moved).complex(), run.simplices());
}

template <int m>
void expect_same_complex(const CertifiedRun<m>& run) {
  expect_rounding_is_harmless<m>(run);
  EXPECT_EQ(CgalTorus<m>(run.result.points.approximate_all()).complex(), run.simplices());
}

TEST(PeriodicDelaunay, square_torus_1_24_in_theory_mode) {
  const auto run = certified_run<2>("torus-2", 24, RunMode::theory);
  expect_same_complex<2>(run);
  expect_twins_noticed<2>(run);
}
TEST(PeriodicDelaunay, square_torus_1_24_in_measured_mode) {
  const auto run = certified_run<2>("torus-2", 24, RunMode::measured);
  expect_same_complex<2>(run);
  expect_twins_noticed<2>(run);
}
TEST(PeriodicDelaunay, square_torus_1_60_in_theory_mode) {
  expect_same_complex<2>(certified_run<2>("torus-2", 60, RunMode::theory));
}
TEST(PeriodicDelaunay, square_torus_1_60_in_measured_mode) {
  expect_same_complex<2>(certified_run<2>("torus-2", 60, RunMode::measured));
}
TEST(PeriodicDelaunay, cubic_torus_1_24_in_theory_mode) {
  const auto run = certified_run<3>("torus-3", 24, RunMode::theory);
  expect_same_complex<3>(run);
  expect_twins_noticed<3>(run);
}
TEST(PeriodicDelaunay, cubic_torus_1_24_in_measured_mode) {
  expect_same_complex<3>(certified_run<3>("torus-3", 24, RunMode::measured));
}

}  // namespace
}  // namespace delcert::test
