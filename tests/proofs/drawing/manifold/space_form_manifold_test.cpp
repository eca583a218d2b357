#include "proofs/drawing/manifold/space_form_manifold.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

/// The lift that the atlas of the run computes, by its own arithmetic.
TEST(SpaceFormManifold, PointsAreWhereTheAtlasHasThem) {
  const auto sample = test::space_form_run<2>("bolza-surface", test::ratio(1, 8));
  const CertificateSummary certificate = test::certificate_of(sample);
  const SpaceFormManifold manifold(certificate);
  for (std::uint32_t label = 0; label < certificate.points.size(); label += 97) {
    const auto place = manifold.place(label, 0);
    ASSERT_TRUE(place.has_value());
    EXPECT_NEAR((*place)[0] * (*place)[0] - (*place)[1] * (*place)[1] - (*place)[2] * (*place)[2], 1, 1e-9);
    // Its own chart shows it at its tangent vector.
    const auto own = manifold.in_chart(label, label, 0);
    ASSERT_TRUE(own.has_value());
    for (std::size_t axis = 0; axis < 2; ++axis)
      EXPECT_NEAR((*own)[axis], approximate_double(certificate.points[label][axis]), 1e-9);
    // A neighbour is where the atlas carries it.
    for (const Sighting<2>& seen : sample.atlas.neighbours(Label(label))) {
      if (seen.element != 0) continue;
      Vector<BigInterval, 2> home;
      for (std::size_t axis = 0; axis < 2; ++axis) home[axis] = BigInterval(certificate.points[seen.index][axis]);
      const auto carried = sample.atlas.carry(Label(label), seen, home);
      const auto shown = manifold.in_chart(label, seen.index, 0);
      ASSERT_TRUE(shown.has_value());
      for (std::size_t axis = 0; axis < 2; ++axis)
        EXPECT_NEAR((*shown)[axis], approximate_double(carried[axis].lower()), 1e-9);
    }
  }
}

TEST(SpaceFormManifold, ModelsOfASphereAgree) {
  const std::size_t manifold_size = drawn_certificates().at("sphere-2").points.size();
  const SpaceFormManifold manifold(drawn_certificates().at("sphere-2"));
  std::size_t in_front = 0;
  for (std::uint32_t label = 0; label < manifold_size; ++label) {
    const auto place = *manifold.place(label, 0);
    const auto unit = manifold.drawn(DrawingModel::unit, place).value();
    EXPECT_NEAR(std::hypot(unit[0], unit[1], unit[2]), 1, 1e-12);
    const auto disk = manifold.drawn(DrawingModel::stereographic, place).value();
    EXPECT_NEAR(disk[0] * (1 + unit[2]), unit[0], 1e-12);
    const auto flat = manifold.drawn(DrawingModel::gnomonic, place);
    EXPECT_EQ(flat.has_value(), unit[2] > 1e-9);
    if (flat) {
      ++in_front;
      EXPECT_NEAR((*flat)[1] * unit[2], unit[1], 1e-12);
    }
  }
  EXPECT_GT(in_front, 0U);
  EXPECT_LT(in_front, manifold_size);
}

TEST(SpaceFormManifold, WhatIsNotAsTheFormatSaysIsRefused) {
  CertificateSummary certificate = drawn_certificates().at("bolza-surface");
  certificate.elements.back() = {0, 99};
  EXPECT_THROW(SpaceFormManifold{certificate}, InputError);
  certificate = drawn_certificates().at("klein-bottle");
  certificate.net_text = "[]";
  EXPECT_THROW(SpaceFormManifold{certificate}, InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
