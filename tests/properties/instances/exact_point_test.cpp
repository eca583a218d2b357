#include "properties/instances/exact_point.hpp"

#include <gtest/gtest.h>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(ExactPoint, pairs_and_combines) {
  const ExactPoint a{Rational(1), Rational(Integer(1), Integer(2)), Rational(-3)};
  const ExactPoint b{Rational(4), Rational(Integer(2), Integer(3)), Rational(5)};
  EXPECT_EQ(pairing(a, b), Rational(Integer(-32), Integer(3)));
  const ExactPoint expected{Rational(-7), Rational(Integer(-5), Integer(6)), Rational(-13)};
  EXPECT_EQ(combined(a, Rational(-2), b), expected);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
