#include "kernel/number/nearest_double.hpp"

#include <gtest/gtest.h>

#include "bench/plain/tolerant_double.hpp"
#include "kernel/number/plain_double.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

template <class Number>
class NearestDoubles : public testing::Test {};
using Orders = testing::Types<PlainDouble, TolerantDouble>;
TYPED_TEST_SUITE(NearestDoubles, Orders);

TYPED_TEST(NearestDoubles, every_operation_is_the_one_of_doubles_in_rounding_to_nearest) {
  const double a = -0x1.999999999999ap-4;
  const double b = 0x1.5555555555555p+3;
  const TypeParam x = TypeParam::exactly(a);
  const TypeParam y = TypeParam::exactly(b);
  EXPECT_EQ((x + y).lower(), a + b);
  EXPECT_EQ((x - y).upper(), a - b);
  EXPECT_EQ((x * y).lower(), a * b);
  EXPECT_EQ((x / y).lower(), a / b);
  EXPECT_EQ((-x).lower(), -a);
  EXPECT_EQ(square(x).lower(), a * a);
  EXPECT_EQ(square_root(y).lower(), std::sqrt(b));
  EXPECT_EQ(square_root(x).lower(), 0.0);
  EXPECT_EQ(absolute(x).lower(), -a);
  EXPECT_EQ(minimum(x, y).lower(), a);
  EXPECT_EQ(maximum(x, y).lower(), b);
  EXPECT_EQ(TypeParam::between(a, b).lower(), TypeParam::between(a, b).upper());
  EXPECT_EQ(TypeParam::between(1.0, 2.0).lower(), 1.5);
  EXPECT_EQ(TypeParam(7).lower(), 7.0);
  TypeParam z = x;
  z += y;
  z -= x;
  z *= y;
  EXPECT_EQ(z.lower(), (a + b - a) * b);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
