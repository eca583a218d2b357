#include "proofs/drawing/drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

double area_of(const Drawing& drawing, std::size_t simplex) {
  std::array<std::array<double, 3>, 3> x{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < drawing.ambient_dimension; ++axis)
      x[k][axis] = drawing.coordinates[drawing.simplices[3 * simplex + k] * drawing.ambient_dimension + axis];
  }
  const auto u = [&x](std::size_t axis) { return x[1][axis] - x[0][axis]; };
  const auto v = [&x](std::size_t axis) { return x[2][axis] - x[0][axis]; };
  const double z = u(0) * v(1) - u(1) * v(0);
  if (drawing.ambient_dimension == 2) return z / 2;
  return std::hypot(u(1) * v(2) - u(2) * v(1), u(2) * v(0) - u(0) * v(2), z) / 2;
}

double area_of(const Drawing& drawing) {
  double sum = 0;
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) sum += area_of(drawing, simplex);
  return sum;
}

TEST(Drawing, OfFlatManifoldsHasTheirArea) {
  EXPECT_NEAR(area_of(drawing_of(drawn_certificates().at("flat-torus"), {})), 1, 1e-9);
  EXPECT_NEAR(area_of(drawing_of(drawn_certificates().at("metric-field"), {})), 1, 1e-9);
  // Half of a lattice cell of 2 by 1.
  EXPECT_NEAR(area_of(drawing_of(drawn_certificates().at("klein-bottle"), {})), 1, 1e-9);
  EXPECT_NEAR(area_of(drawing_of(drawn_certificates().at("sphere-2"), {})), 4 * std::acos(-1.0), 0.1);
  EXPECT_NEAR(area_of(drawing_of(drawn_certificates().at("projective-plane"), {})), 2 * std::acos(-1.0), 0.05);
  EXPECT_NEAR(area_of(drawing_of(drawn_certificates().at("submanifold"), {})), 4 * std::acos(-1.0), 0.1);
  // Stretched over the whole cell it is no longer so.
  DrawingOptions quotient;
  quotient.copies = DrawingCopies::quotient;
  EXPECT_GT(std::fabs(area_of(drawing_of(drawn_certificates().at("flat-torus"), quotient)) - 1), 1e-3);
}

TEST(Drawing, OfAHyperbolicSurfaceIsInTheDiskAndPositivelyOriented) {
  const Drawing drawing = drawing_of(drawn_certificates().at("bolza-surface"), {});
  EXPECT_EQ(drawing.model, DrawingModel::conformal);
  EXPECT_EQ(drawing.geometry, "hyperbolic");
  ASSERT_EQ(drawing.ambient_dimension, 2U);
  for (std::size_t vertex = 0; vertex < drawing.vertex_count(); ++vertex)
    EXPECT_LT(std::hypot(drawing.coordinates[2 * vertex], drawing.coordinates[2 * vertex + 1]), 1);
  for (std::size_t simplex = 0; simplex < drawing.simplex_count(); ++simplex) EXPECT_GT(area_of(drawing, simplex), 0);
  // The octagon: eight sides that end at the same distance from the middle.
  ASSERT_FALSE(drawing.domain.empty());
  double farthest = 0;
  for (std::size_t at = 0; at < drawing.domain.size(); at += 2)
    farthest = std::max(farthest, std::hypot(drawing.domain[at], drawing.domain[at + 1]));
  EXPECT_NEAR(farthest, std::pow(2, -0.25), 1e-9);
}

TEST(Drawing, OfSurfacesInSpaceHasNormalsToTheOutside) {
  for (const char* name : {"sphere-2", "submanifold"}) {
    const Drawing drawing = drawing_of(drawn_certificates().at(name), {});
    ASSERT_EQ(drawing.ambient_dimension, 3U);
    const auto x = [&drawing](std::size_t k, std::size_t axis) {
      return drawing.coordinates[3 * drawing.simplices[k] + axis];
    };
    for (std::size_t first = 0; first < drawing.simplices.size(); first += 3) {
      const double volume = x(first, 0) * (x(first + 1, 1) * x(first + 2, 2) - x(first + 1, 2) * x(first + 2, 1)) -
                            x(first, 1) * (x(first + 1, 0) * x(first + 2, 2) - x(first + 1, 2) * x(first + 2, 0)) +
                            x(first, 2) * (x(first + 1, 0) * x(first + 2, 1) - x(first + 1, 1) * x(first + 2, 0));
      EXPECT_GT(volume, 0) << name;
    }
  }
}

TEST(Drawing, InAModelThatIsNotOfTheFamilyIsRefused) {
  DrawingOptions options;
  options.model = DrawingModel::gnomonic;
  EXPECT_THROW((void)drawing_of(drawn_certificates().at("flat-torus"), options), InputError);
  // Half of the sphere is not shown.
  EXPECT_THROW((void)drawing_of(drawn_certificates().at("sphere-2"), options), InputError);
  EXPECT_NO_THROW((void)drawing_of(drawn_certificates().at("bolza-surface"), options));
}

TEST(Drawing, OfBrokenRowsIsRefused) {
  CertificateSummary certificate = test::torus_certificate();
  const CertificateSummary whole = certificate;
  certificate.simplices[0].pop_back();
  EXPECT_THROW((void)drawing_of(certificate, {}), InputError);
  certificate = whole;
  certificate.simplices[0][2] = static_cast<std::uint32_t>(certificate.points.size());
  EXPECT_THROW((void)drawing_of(certificate, {}), InputError);
  certificate = whole;
  certificate.simplices[0][4] = static_cast<std::uint32_t>(certificate.elements.size() + 1);
  EXPECT_THROW((void)drawing_of(certificate, {}), InputError);
  certificate = whole;
  std::swap(certificate.simplices[0][0], certificate.simplices[0][1]);
  EXPECT_THROW((void)drawing_of(certificate, {}), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
