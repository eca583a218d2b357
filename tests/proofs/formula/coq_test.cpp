#include "proofs/formula/coq.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/type_check.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

ExpressionPointer checked(std::string_view text, const Type& type) {
  const Signature signature{{"s", {"simplex", false}}, {"k", types::integer}, {"m", types::integer},
                            {"xi", types::number},     {"R", types::number},  {"at", types::number}};
  return type_checked(parse_formula(text), full_vocabulary(), signature, type);
}
std::string coq(std::string_view text, const CoqNames& names = {}) {
  return coq_of(*checked(text, types::number), names).value_or("none");
}
std::string coq_statement(std::string_view text) { return coq_of(*checked(text, types::truth)).value_or("none"); }

TEST(Coq, terms_keep_their_tree) {
  EXPECT_EQ(coq("1 + 2*k - xi"), "((1 + (2 * k)) - xi)");
  EXPECT_EQ(coq("-xi^2"), "(- (xi ^ 2))");
  EXPECT_EQ(coq("xi/k/m"), "((xi / k) / m)");
  EXPECT_EQ(coq("min(1, xi, k)"), "(Rmin (Rmin 1 xi) k)");
  EXPECT_EQ(coq("abs(xi) + max(1, k)"), "((Rabs xi) + (Rmax 1 k))");
  EXPECT_EQ(coq("log2(k)"), "(ln k / ln 2)");
}

TEST(Coq, powers_say_what_the_formula_says) {
  EXPECT_EQ(coq("xi^0"), "(xi ^ 0)");
  EXPECT_EQ(coq("xi^(-2)"), "(/ (xi ^ 2))");
  EXPECT_EQ(coq("k^(3/2)"), "((sqrt k) ^ 3)");
  EXPECT_EQ(coq("k^(-1/2)"), "(/ ((sqrt k) ^ 1))");
  EXPECT_EQ(coq("xi^(2*m + 1)"), "(Rpower xi ((2 * m) + 1))");
  EXPECT_EQ(coq("2^(m/2)"), "(Rpower 2 (m / 2))");
}

TEST(Coq, statements) {
  EXPECT_EQ(coq_statement("0 < xi <= 1"), "((0 < xi) /\\ (xi <= 1))");
  EXPECT_EQ(coq_statement("not xi = 0 or k >= m"), "((~ (xi = 0)) \\/ (k >= m))");
  EXPECT_EQ(coq_statement("xi > 0 implies k < m"), "((xi > 0) -> (k < m))");
}

TEST(Coq, names_that_mean_something_else_there) {
  EXPECT_EQ(coq("R + at"), "(R_ + at_)");
  EXPECT_EQ(coq("k + xi", {{"k", "(root_k * root_k)"}}), "((root_k * root_k) + xi)");
}

TEST(Coq, what_has_no_counterpart) {
  EXPECT_EQ(coq("thickness(s)"), "none");
  EXPECT_EQ(coq("flake_parameter(m, xi, xi)"), "none");
  EXPECT_EQ(coq_statement("forall i in 0..k: i <= k"), "none");
}

TEST(Coq, numbers) {
  EXPECT_EQ(coq_number(Rational(3)), "3");
  EXPECT_EQ(coq_number(Rational(-3)), "(-3)");
  EXPECT_EQ(coq_number(Rational(-3) / Rational(4)), "(-3 / 4)");
}

TEST(Coq, rational_constants) {
  const auto value = [](std::string_view text) { return rational_constant(*checked(text, types::number)); };
  EXPECT_EQ(value("2*3 - 7/2"), Rational(5) / Rational(2));
  EXPECT_EQ(value("2^-3"), Rational(1) / Rational(8));
  EXPECT_EQ(value("1/(1 - 1)"), std::nullopt);
  EXPECT_EQ(value("0^-1"), std::nullopt);
  EXPECT_EQ(value("2^(1/2)"), std::nullopt);
  EXPECT_EQ(value("xi"), std::nullopt);
  EXPECT_EQ(value("sqrt(4)"), std::nullopt);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
