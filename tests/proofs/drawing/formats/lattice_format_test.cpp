#include "proofs/drawing/formats/lattice_format.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// A triangle and what it takes to write it: not the triangulation of a torus.
CertificateSummary triangle() {
  CertificateSummary result;
  result.family = "flat-torus";
  result.manifold.name = "triangle";
  result.manifold.dimension = Dimension(2);
  result.manifold_text =
      R"({"name":"triangle","family":"flat-torus","dimension":2,"gram":[["1","1/2"],["1/2","0x3p-1"]]})";
  result.points = {{Rational(Integer(1), Integer(2)), 0}, {Rational(Integer(-1), Integer(3)), 1}, {0, 0}};
  result.elements = {{1, 0}, {0, -1}};
  result.simplices = {{0, 1, 2, 0, 2}, {0, 1, 2, 1, 0}};
  return result;
}

std::string text_of(const CertificateSummary& certificate, const char* note = "") {
  ExportContent content{certificate};
  content.note = note;
  const std::string text = lattice_text(content);
  return text.substr(text.find('\n') + 1);
}

TEST(LatticeFormat, HasIntegersWithOneDenominator) {
  EXPECT_EQ(text_of(triangle()),
            "delcert-lattice 1\ndimension 2\nperiod 6\ngram\n2 1\n1 3\npoints 3\n3 0\n-2 6\n0 0\n"
            "simplices 2\n0 0 0  1 0 0  2 0 -1\n0 0 0  1 1 0  2 0 0\n");
}

TEST(LatticeFormat, RefusesWhatIsNoFlatTorus) {
  EXPECT_NO_THROW(require_lattice(triangle()));
  EXPECT_THROW(require_lattice(test::drawn_certificates().at("klein-bottle")), InputError);
  EXPECT_THROW((void)text_of(triangle(), "simplified"), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
