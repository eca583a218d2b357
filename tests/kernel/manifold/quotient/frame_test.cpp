#include "kernel/manifold/quotient/frame.hpp"

#include <gtest/gtest.h>

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

constexpr std::array all_curvatures{Curvature::negative, Curvature::zero, Curvature::positive};

TEST(Frame, does_what_its_matrix_does) {
  const Vector<Rational, 3> a{ratio(3, 7), ratio(-5, 8), ratio(1, 3)};
  const ModelPoint<Rational, 3> x{ratio(9, 4), ratio(1, 5), ratio(-2, 3), ratio(7, 6)};
  for (const Curvature curvature : all_curvatures) {
    const Frame<Rational, 3> frame(curvature, a);
    EXPECT_EQ(frame.applied(x), applied(model_frame<Rational, 3>(curvature, a), x));
    EXPECT_EQ(frame.inverse_applied(x), applied(inverse_model_frame<Rational, 3>(curvature, a), x));
    EXPECT_EQ(frame.inverse_applied(frame.applied(x)), x);
    EXPECT_EQ(frame.point(), (model_point<Rational, 3>(curvature, a)));
    EXPECT_NE(frame.applied(x), frame.inverse_applied(x));
  }
}

TEST(Frame, sees_conformal_coordinates) {
  const Vector<Rational, 3> a{ratio(3, 7), ratio(-5, 8), ratio(1, 3)};
  const Vector<Rational, 3> b{ratio(1, 2), ratio(-2, 3), ratio(1, 4)};
  for (const Curvature curvature : all_curvatures) {
    const Frame<Rational, 3> frame(curvature, a);
    const auto x = model_point<Rational, 3>(curvature, b);
    EXPECT_EQ(frame.conformal_seen(x), (conformal_coordinates<Rational, 3>(frame.inverse_applied(x))));
    EXPECT_EQ(frame.conformal_seen(frame.point()), (Vector<Rational, 3>{}));
  }
}

TEST(Frame, sees_tightly_from_far_away_in_hyperbolic_space) {
  // At a distance of about 5 from o.
  const Vector<Rational, 2> a{ratio(63, 32), ratio(1, 8)};
  const Vector<Rational, 2> b{ratio(63, 32), ratio(17, 128)};
  const auto enclosed = [](const Vector<Rational, 2>& x) {
    return Vector<Interval, 2>{scalar_from<Interval>(x[0]), scalar_from<Interval>(x[1])};
  };
  const RoundingGuard guard;
  const Frame<Interval, 2> frame(Curvature::negative, enclosed(a));
  const auto x = model_point<Interval, 2>(Curvature::negative, enclosed(b));
  const auto exact =
      Frame<Rational, 2>(Curvature::negative, a).conformal_seen(model_point<Rational, 2>(Curvature::negative, b));
  const auto seen = frame.conformal_seen(x);
  const auto by_products = conformal_coordinates<Interval, 2>(frame.inverse_applied(x));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_LE(Rational::exactly(seen[axis].lower()), exact[axis]);
    EXPECT_GE(Rational::exactly(seen[axis].upper()), exact[axis]);
    EXPECT_LT(10 * (seen[axis].upper() - seen[axis].lower()), by_products[axis].upper() - by_products[axis].lower());
  }
}

TEST(Frame, takes_o_to_its_point) {
  const Vector<Rational, 2> a{ratio(3, 7), ratio(-5, 8)};
  const ModelPoint<Rational, 2> origin{Rational(1), Rational(0), Rational(0)};
  for (const Curvature curvature : all_curvatures) {
    const Frame<Rational, 2> frame(curvature, a);
    EXPECT_EQ(frame.applied(origin), frame.point());
    EXPECT_EQ(frame.inverse_applied(frame.point()), origin);
  }
}

TEST(Frame, is_the_identity_by_default) {
  const ModelPoint<Rational, 2> x{Rational(1), ratio(3, 4), ratio(5, 6)};
  EXPECT_EQ((Frame<Rational, 2>().applied(x)), x);
}

TEST(Frame, encloses_tightly_next_to_minus_o) {
  const Vector<Rational, 2> a{Rational(40000000), Rational(-30000001)};
  const ModelPoint<Rational, 2> x{ratio(3, 5), ratio(4, 5), Rational(0)};
  const auto exact = Frame<Rational, 2>(Curvature::positive, a).applied(x);
  const RoundingGuard guard;
  Vector<Interval, 2> enclosed;
  for (std::size_t axis = 0; axis < 2; ++axis) enclosed[axis] = scalar_from<Interval>(a[axis]);
  ModelPoint<Interval, 2> point;
  for (std::size_t axis = 0; axis < 3; ++axis) point[axis] = scalar_from<Interval>(x[axis]);
  const auto enclosure = Frame<Interval, 2>(Curvature::positive, enclosed).applied(point);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_LE(Rational::exactly(enclosure[axis].lower()), exact[axis]);
    EXPECT_GE(Rational::exactly(enclosure[axis].upper()), exact[axis]);
    EXPECT_LE(enclosure[axis].upper() - enclosure[axis].lower(), 0x1p-47);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
