#include "proofs/drawing/manifold/tangent_manifold.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

TEST(TangentManifold, PointsAreOnTheManifoldOverTheirCoordinates) {
  const CertificateSummary& certificate = drawn_certificates().at("submanifold");
  const auto net = certificate.net();
  const TangentManifold manifold(certificate);
  double farthest = 0;
  for (std::uint32_t label = 0; label < certificate.points.size(); ++label) {
    const auto place = *manifold.place(label, 0);
    EXPECT_NEAR(std::hypot(place[0], place[1], place[2]), 1, 1e-12);
    const auto own = *manifold.in_chart(label, label, 0);
    double from_centre = 0;
    for (std::size_t axis = 0; axis < 2; ++axis)
      EXPECT_NEAR(own[axis], approximate_double(certificate.points[label][axis]), 1e-12);
    for (std::size_t axis = 0; axis < 3; ++axis)
      from_centre = std::max(from_centre, std::fabs(place[axis] - approximate_double(net[label][axis])));
    farthest = std::max(farthest, from_centre);
  }
  // The points were moved: their centres are not what is drawn.
  EXPECT_GT(farthest, 1e-4);
}

TEST(TangentManifold, EquationsThatHaveNoPointThereAreNoticed) {
  CertificateSummary certificate = drawn_certificates().at("submanifold");
  const std::string equation = "x^2+y^2+z^2-1";
  const std::size_t at = certificate.manifold_text.find(equation);
  ASSERT_NE(at, std::string::npos);
  certificate.manifold_text.replace(at, equation.size(), "x^2+y^2+z^2+1");
  EXPECT_THROW(TangentManifold{certificate}, InputError);
}

TEST(TangentManifold, ChartsOfTheWrongSizeAreRefused) {
  CertificateSummary certificate = drawn_certificates().at("submanifold");
  certificate.charts[3].pop_back();
  EXPECT_THROW(TangentManifold{certificate}, InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
