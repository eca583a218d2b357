#include "proofs/drawing/formats/complex_formats.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::string text_of(const CertificateSummary& certificate, const LabelComplex& complex, const char* name) {
  ExportContent content{certificate};
  content.complex = &complex;
  return export_format(name).text(content);
}

/// The boundary of a 4-simplex, as a certificate could have it.
CertificateSummary three_sphere() {
  CertificateSummary result;
  result.manifold.name = "a \"<name>\" & more";
  result.manifold.dimension = Dimension(3);
  result.points.resize(5);
  for (std::uint32_t without = 0; without < 5; ++without) {
    std::vector<std::uint32_t> row;
    for (std::uint32_t k = 0; k < 5; ++k) {
      if (k != without) row.push_back(k);
    }
    row.resize(7);
    result.simplices.push_back(row);
  }
  return result;
}

/// The sphere bundle over the circle that cannot be oriented, with nine vertices: the boundary of the 4-simplices
/// {i, …, i + 4} modulo 9, a handle of dimension 4 (W. Kühnel, Higherdimensional analogues of Császár's torus, 1986).
CertificateSummary sphere_bundle_that_cannot_be_oriented() {
  constexpr std::uint32_t n = 9;
  CertificateSummary result;
  result.manifold.name = "S2~S1";
  result.manifold.dimension = Dimension(3);
  result.points.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    // Without its first vertex or its last one it is glued to its neighbour.
    for (std::uint32_t without = 1; without < 4; ++without) {
      std::vector<std::uint32_t> row;
      for (std::uint32_t k = 0; k < 5; ++k) {
        if (k != without) row.push_back((i + k) % n);
      }
      std::sort(row.begin(), row.end());
      row.resize(7);
      result.simplices.push_back(row);
    }
  }
  return result;
}

// What programs read of them is in tests/receivers.
TEST(ComplexFormats, OfASphere) {
  const CertificateSummary certificate = three_sphere();
  const LabelComplex complex = label_complex(certificate);
  const std::string faces = text_of(certificate, complex, "simplex-tree");
  EXPECT_EQ(std::count(faces.begin(), faces.end(), '\n'), 5 + 10 + 10 + 5);
  EXPECT_TRUE(faces.starts_with("0 0 0\n0 1 0\n"));
  EXPECT_TRUE(faces.ends_with("3 1 2 3 4 0\n"));
  const std::string regina = text_of(certificate, complex, "regina");
  EXPECT_NE(regina.find("<tri dim=\"3\" size=\"5\" perm=\"index\""), std::string::npos);
  EXPECT_NE(regina.find("&lt;name>"), std::string::npos);
  const std::string snappea = text_of(certificate, complex, "snappea");
  EXPECT_TRUE(snappea.starts_with("% Triangulation\n"));
  EXPECT_NE(snappea.find("\noriented_manifold\n"), std::string::npos);
  EXPECT_EQ(text_of(certificate, complex, "isosig"), "fvPQccdedeegovcfb\n");
}

TEST(ComplexFormats, OnlySnapPeaRefusesWhatCannotBeOriented) {
  const CertificateSummary certificate = sphere_bundle_that_cannot_be_oriented();
  const LabelComplex complex = label_complex(certificate);
  ASSERT_TRUE(complex.is_closed);
  ASSERT_EQ(complex.simplex_count(), 27U);
  EXPECT_NO_THROW((void)text_of(certificate, complex, "regina"));
  EXPECT_NO_THROW((void)text_of(certificate, complex, "isosig"));
  try {
    (void)text_of(certificate, complex, "snappea");
    ADD_FAILURE() << "it was written";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "this complex cannot be oriented, and is not written for SnapPea");
  }
}

TEST(ComplexFormats, RefuseWhatTheyCannotHold) {
  const auto& klein = test::drawn_certificates().at("klein-bottle");
  EXPECT_THROW(export_format("snappea").check(klein), InputError);
  EXPECT_NO_THROW(export_format("snappea").check(three_sphere()));
  EXPECT_THROW(export_format("off").check(three_sphere()), InputError);
  CertificateSummary two = three_sphere();
  // A second one, apart from it.
  two.points.resize(10);
  for (std::size_t at = 0; at < 5; ++at) {
    two.simplices.push_back(two.simplices[at]);
    for (std::size_t k = 0; k < 4; ++k) two.simplices.back()[k] += 5;
  }
  EXPECT_THROW((void)text_of(two, label_complex(two), "isosig"), InputError);
  CertificateSummary open = three_sphere();
  open.simplices.pop_back();
  EXPECT_THROW((void)text_of(open, label_complex(open), "snappea"), InputError);
  EXPECT_NO_THROW((void)text_of(open, label_complex(open), "regina"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
