#include "proofs/drawing/manifold/torus_manifold.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

TEST(TorusManifold, SheetsAreTranslations) {
  TorusManifold manifold(drawn_certificates().at("flat-torus"));
  const CertificateSummary& certificate = drawn_certificates().at("flat-torus");
  for (std::uint32_t element = 1; element <= certificate.elements.size(); ++element) {
    const std::uint32_t sheet = manifold.vertex_sheet(0, element);
    const auto here = *manifold.place(0, 0);
    const auto there = *manifold.place(0, sheet);
    std::string text;
    for (std::size_t axis = 1; axis <= manifold.dimension(); ++axis) {
      const double step = there[axis] - here[axis];
      EXPECT_NEAR(step, std::round(step), 1e-12);
      text += (axis == 1 ? "" : " ") + std::to_string(std::lround(step));
    }
    EXPECT_EQ(manifold.sheet_text(sheet), text);
  }
}

TEST(TorusManifold, BarycentresOfItsCellAreInTheUnitCube) {
  const CertificateSummary& certificate = drawn_certificates().at("flat-torus");
  TorusManifold manifold(certificate);
  const std::size_t m = manifold.dimension();
  for (const std::vector<std::uint32_t>& row : certificate.simplices) {
    DrawnSimplex simplex{0, {row.begin(), row.begin() + static_cast<std::ptrdiff_t>(m + 1)}, {0}};
    simplex.elements.insert(simplex.elements.end(), row.begin() + static_cast<std::ptrdiff_t>(m + 1), row.end());
    const std::uint32_t cell = manifold.cell_sheet(simplex);
    for (std::size_t axis = 1; axis <= m; ++axis) {
      double sum = 0;
      for (std::size_t k = 0; k <= m; ++k)
        sum += (*manifold.place(simplex.labels[k], manifold.vertex_sheet(cell, simplex.elements[k])))[axis];
      EXPECT_GE(sum, -1e-9);
      EXPECT_LT(sum, static_cast<double>(m + 1) + 1e-9);
    }
  }
  EXPECT_EQ(manifold.domain().size(), m << (m - 1));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
