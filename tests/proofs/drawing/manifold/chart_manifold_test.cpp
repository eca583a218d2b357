#include "proofs/drawing/manifold/chart_manifold.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

TEST(ChartManifold, TransitionsAreThoseOfTheFile) {
  // On the sphere in two stereographic charts a point goes to its inverse by the unit circle.
  const CertificateSummary& certificate = drawn_certificates().at("atlas");
  const ChartManifold manifold(certificate);
  std::size_t in_both = 0;
  std::set<std::uint32_t> homes;
  for (std::uint32_t label = 0; label < certificate.points.size(); ++label) {
    const std::uint32_t home = manifold.home_sheet(label);
    homes.insert(home);
    const auto here = manifold.place(label, home);
    const auto there = manifold.place(label, 1 - home);
    ASSERT_TRUE(here.has_value());
    if (!there) continue;
    ++in_both;
    EXPECT_NEAR(std::hypot((*here)[1], (*here)[2]) * std::hypot((*there)[1], (*there)[2]), 1, 1e-9);
  }
  EXPECT_EQ(homes.size(), 2U);
  EXPECT_GT(in_both, 0U);
  EXPECT_LT(in_both, certificate.points.size());
}

TEST(ChartManifold, ChartsAreDrawnSideBySide) {
  const CertificateSummary& certificate = drawn_certificates().at("atlas");
  const ChartManifold manifold(certificate);
  double right_of_first = -1e9;
  double left_of_second = 1e9;
  for (std::uint32_t label = 0; label < certificate.points.size(); ++label) {
    const std::uint32_t home = manifold.home_sheet(label);
    const double x = manifold.drawn(DrawingModel::unit, *manifold.place(label, home)).value()[0];
    (home == 0 ? right_of_first : left_of_second) =
        home == 0 ? std::max(right_of_first, x) : std::min(left_of_second, x);
  }
  EXPECT_LT(right_of_first, left_of_second);
}

TEST(ChartManifold, AHomeThatIsNoneIsRefused) {
  CertificateSummary certificate = drawn_certificates().at("atlas");
  certificate.charts[0][0] = Rational(7);
  EXPECT_THROW(ChartManifold{certificate}, InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
