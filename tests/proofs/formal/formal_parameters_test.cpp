#include "proofs/formal/formal_parameters.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

FormalParameter parameter(const std::string& name, std::string_view range, bool squared = false) {
  return {name, parse_step_range(range), squared};
}

TEST(FormalParameters, premises) {
  EXPECT_EQ(range_premises({parameter("xi", "(0, 1/4]"), parameter("k", "integer [1, infinity)"),
                            parameter("x", "(-infinity, infinity)")}),
            "  0 < xi -> xi <= (1 / 4) ->\n  1 <= k ->\n");
}

TEST(FormalParameters, the_roots_of_squared_ones) {
  const FormalParameter m = parameter("m", "[4, 9)", true);
  EXPECT_EQ(m.text(), "(root_m * root_m)");
  EXPECT_EQ(m.variable().lower, Rational(2));
  EXPECT_EQ(m.variable().upper, Rational(3));
  EXPECT_TRUE(m.variable().upper_open);
  const FormalVariable rounded = parameter("m", "[2, 13/5]", true).variable();
  EXPECT_LT(square(*rounded.lower), Rational(2));
  EXPECT_GT(square(*rounded.lower), Rational(19999) / Rational(10000));
  EXPECT_GT(square(*rounded.upper), Rational(13) / Rational(5));
}

TEST(FormalParameters, introduction_names_everything_in_order) {
  EXPECT_EQ(introduction({parameter("k", "[1, infinity)"), parameter("at", "(0, 1]")}, 1),
            "intros k at_ k_lower at__lower at__upper given_1.\n");
  const std::string with_root = introduction({parameter("k", "[1, infinity)", true)}, 0);
  EXPECT_NE(with_root.find("subst k."), std::string::npos);
  EXPECT_NE(with_root.find("assert (1 <= root_k) by (apply (root_at_least root_k 1 1); lra)."), std::string::npos);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
