#include "proofs/publication/certificate_table.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

CertificateSummary certificate() {
  CertificateSummary result;
  result.manifold.name = "torus_2";
  result.manifold.dimension = Dimension(2);
  result.parameters = {{"sampling_radius", "1/10"}};
  result.levels = {{"1", {{"protection", "0x237p-17"}, {"thickness", "1/7"}, {"circumradius", "0x775p-14"}}},
                   {"2", {{"closed", "true"}, {"homology", "Z, Z^2 + Z/3, 0"}}},
                   {"2s", {}},
                   {"6", {{"bilipschitz", "1/3, 2"}}}};
  result.points.resize(3);
  result.simplices.resize(4);
  result.seal = std::string(63, 'a') + "b";
  result.sealed_bytes = result.seal;
  return result;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(CertificateTable, has_margins_exactly_and_rounded_to_the_safe_side) {
  const std::string latex = certificate_latex(certificate());
  EXPECT_TRUE(has(latex, "$\\ge 567 \\cdot 2^{-17}$ & $\\ge 0.004325$ & $\\ge 0.04325$ \\\\\n")) << latex;
  EXPECT_TRUE(has(latex, "$\\ge 1/7$ & $\\ge 0.1428$ &  \\\\\n")) << latex;
  EXPECT_TRUE(has(latex, "$\\le 1909 \\cdot 2^{-14}$ & $\\le 0.1166$ & $\\le 1.166$ \\\\\n")) << latex;
  EXPECT_TRUE(has(latex, "$\\ge 1/3$ & $\\ge 0.3333$ ")) << latex;
  EXPECT_TRUE(has(latex, "$\\le 2$ & $\\le 2$ ")) << latex;
}

TEST(CertificateTable, says_what_is_claimed_besides) {
  const std::string latex = certificate_latex(certificate());
  EXPECT_TRUE(has(latex, "torus\\_\\allowbreak{}2, dimension 2, $n = 3$ points, $4$ simplices, $\\varepsilon = 1/10$"))
      << latex;
  EXPECT_TRUE(has(latex, "$\\mathbf{Z}$, $\\mathbf{Z}^{2} \\oplus{} \\mathbf{Z}/3$, $0$")) << latex;
  EXPECT_TRUE(has(latex, "2s & & & & \\\\\n")) << latex;
  EXPECT_TRUE(has(latex, "\\cite{delcert-aaaaaaaaaaaa}")) << latex;
  EXPECT_TRUE(has(latex, "\\texttt{aaaaaaaa\\allowbreak ")) << latex;
}

TEST(CertificateTable, is_of_no_certificate_that_was_changed) {
  CertificateSummary changed = certificate();
  changed.sealed_bytes = std::string(64, 'c');
  EXPECT_THROW((void)certificate_latex(changed), InputError);
}

TEST(CertificateTable, rounds_to_the_safe_side) {
  const Rational third = Rational(1) / Rational(3);
  EXPECT_EQ(safe_decimal(third, Margin::Side::lower), "0.3333");
  EXPECT_EQ(safe_decimal(third, Margin::Side::upper), "0.3334");
  const Rational tenth = Rational(1) / Rational(10);
  EXPECT_EQ(safe_decimal_in_radii({third, Margin::Side::lower, Margin::Unit::one}, tenth), "");
  EXPECT_EQ(safe_decimal_in_radii({third, Margin::Side::lower, Margin::Unit::length}, tenth), "3.333");
  EXPECT_EQ(safe_decimal_in_radii({third, Margin::Side::upper, Margin::Unit::squared_length}, tenth), "33.34");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
