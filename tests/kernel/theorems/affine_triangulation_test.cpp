#include "kernel/theorems/affine_triangulation.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The lattice A_m* divided by n: its Delaunay triangulation has no ties.
template <int m>
MetricFieldAtlas<m> lattice_atlas(long n, const Rational& radius) {
  SquareOfRationals gram(static_cast<std::size_t>(m));
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) gram[row].push_back(Rational(row == column ? m : -1));
  }
  return {MetricField<m>(constant_field(gram)), lattice_points<m>(n), radius};
}

template <int m>
std::vector<ChartStar<m>> stars_of(const MetricFieldAtlas<m>& atlas) {
  ChartView<m> view(atlas, atlas.net(), {Curvature::zero, Rational(1), atlas.patch_factor()});
  std::vector<ChartStar<m>> result;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const auto star = chart_star<m>(view, Label(index));
    EXPECT_TRUE(star.failures.empty()) << star.failures.front().reason;
    result.push_back(star.star);
  }
  return result;
}

template <int m>
AffineTriangulationReport report_of(const MetricFieldAtlas<m>& atlas, std::vector<ChartStar<m>> stars) {
  const ChartComplex<m> complex(std::move(stars), std::vector<bool>(atlas.size(), true));
  return check_affine_triangulation<m>(atlas, atlas.net(), complex);
}

TEST(AffineTriangulation, of_lattices_covers_the_torus_once) {
  const auto plane = lattice_atlas<2>(12, ratio(1, 10));
  const auto report = report_of<2>(plane, stars_of<2>(plane));
  EXPECT_TRUE(report.holds());
  EXPECT_EQ(report.listed, 144U * 6);
  EXPECT_LE(report.least_sheets, 1);
  EXPECT_GE(report.most_sheets, 1);
  EXPECT_LE(report.most_sheets - report.least_sheets, 1e-10);
  // All edges have the length √2/12, but for what charts are rounded by.
  EXPECT_LE(report.edge * report.edge, 2.0 / 144 * (1 + 1e-7));
  EXPECT_GE(report.edge * report.edge, 2.0 / 144 * (1 - 1e-7));
  const auto space = lattice_atlas<3>(10, ratio(117, 1000));
  const auto solid = report_of<3>(space, stars_of<3>(space));
  EXPECT_TRUE(solid.holds());
  EXPECT_EQ(solid.listed, 1000U * 24);
  // Every tetrahedron has two edges of the length 2/10, and four of √3/10.
  EXPECT_LE(solid.edge, 0.2 * (1 + 1e-7));
  EXPECT_GE(solid.edge, 0.2 * (1 - 1e-7));
  EXPECT_LE(solid.most_sheets - solid.least_sheets, 1e-10);
  EXPECT_GE(solid.most_sheets, 1);
}

TEST(AffineTriangulation, sees_another_lift) {
  const auto atlas = lattice_atlas<2>(12, ratio(1, 10));
  auto stars = stars_of<2>(atlas);
  ++stars[5].simplices[2][1].shift[0];
  const auto report = report_of<2>(atlas, stars);
  EXPECT_FALSE(report.holds());
  // The simplex in its own star, and in those of the two others.
  EXPECT_EQ(report.other_lifts, 3U);
}

TEST(AffineTriangulation, counts_sheets) {
  // All simplices taken at lifts so far away that they are twice as large and more, but all stars alike: two vertices
  // of every simplex moved by lattice vectors. No such stars are certified.
  const auto atlas = lattice_atlas<2>(12, ratio(1, 10));
  auto stars = stars_of<2>(atlas);
  for (auto& star : stars) {
    for (auto& simplex : star.simplices) {
      // A lift of each label of its own, the same in all stars: its position moved by (label, 0).
      for (auto& seen : simplex)
        seen.shift[0] += static_cast<std::int32_t>(seen.index % 3) - static_cast<std::int32_t>(star.label.value % 3);
    }
    std::sort(star.simplices.begin(), star.simplices.end());
  }
  const auto report = report_of<2>(atlas, stars);
  EXPECT_EQ(report.other_lifts, 0U);
  EXPECT_GT(report.least_sheets, 2);
  EXPECT_FALSE(report.holds());
}

TEST(AffineTriangulation, of_nothing_does_not_hold) {
  const auto atlas = lattice_atlas<2>(12, ratio(1, 10));
  const auto report = report_of<2>(atlas, std::vector<ChartStar<2>>(atlas.size()));
  EXPECT_FALSE(report.holds());
  EXPECT_EQ(report.edge, 0);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
