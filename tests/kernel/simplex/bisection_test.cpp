#include "kernel/simplex/bisection.hpp"

#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

RC_GTEST_PROP(Bisection, EnclosesTheNumberAsTightlyAsAsked, ()) {
  const Rational x = (absolute(*any_coordinate()) + ratio(1, 77)) * Rational::power_of_two(-*rc::gen::inRange(0, 100));
  const auto bits = static_cast<unsigned>(*rc::gen::inRange(1, 90));
  const RationalBounds bounds = bisected(Rational(128), bits, [&](const Rational& t) { return x >= t; });
  RC_ASSERT(bounds.lower <= x);
  RC_ASSERT(x <= bounds.upper);
  RC_ASSERT(bounds.upper - bounds.lower <= bounds.upper * Rational::power_of_two(-static_cast<long>(bits)));
}

TEST(Bisection, KeepsANumberThatItHits) {
  const RationalBounds bounds = bisected(Rational(4), 20, [](const Rational& t) { return Rational(3) >= t; });
  EXPECT_EQ(bounds.lower, Rational(3));
  EXPECT_GT(bounds.upper, Rational(3));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
