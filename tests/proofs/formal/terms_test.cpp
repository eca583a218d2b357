#include "proofs/formal/terms.hpp"

#include <gtest/gtest.h>

#include "proofs/formula/coq.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Terms, are_read_like_those_of_the_parser) {
  const auto sum = binary_term(Operation::add, name_term("x"), power_term(number_term(Rational(2)), 3));
  EXPECT_EQ(coq_of(*sum), "(x + (2 ^ 3))");
  EXPECT_EQ(sum->type, types::number);
  EXPECT_EQ(with_children(sum, sum->children), sum);
  EXPECT_EQ(coq_of(*with_children(sum, {name_term("y"), sum->children[1]})), "(y + (2 ^ 3))");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
