#include "kernel/manifold/gluing/metric_field.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(MetricField, is_the_sum_of_its_waves) {
  const MetricField<2> field(shear());
  const RoundingGuard guard;
  // At (1/4, 0): sin 2πx = 1, cos 2π(x − y) = 0. At (1/4, 1/4): cos 2π(x − y) = 1.
  const auto g = field.at<Interval>({ratio(1, 4), Rational(0)});
  EXPECT_TRUE(holds(g[0][0], Rational(1)));
  EXPECT_TRUE(holds(g[0][1], ratio(1, 10)));
  EXPECT_TRUE(holds(g[1][1], ratio(21, 10)));
  EXPECT_TRUE(holds(field.at<Interval>({ratio(1, 4), ratio(1, 4)})[0][0], ratio(21, 20)));
  EXPECT_LT(g[1][1].upper() - g[1][1].lower(), 1e-14);
  const auto big = field.at<BigInterval>({ratio(1, 7), ratio(2, 7)});
  const auto small = field.at<Interval>({ratio(1, 7), ratio(2, 7)});
  EXPECT_TRUE(holds(small[0][1], big[0][1].lower()));
  EXPECT_TRUE(holds(small[0][0], big[0][0].upper()));
  // Periodic.
  const auto moved = field.at<BigInterval>({ratio(8, 7), ratio(-5, 7)});
  EXPECT_EQ(moved[1][1].lower(), big[1][1].lower());
}

TEST(MetricField, is_enclosed_on_boxes) {
  const MetricField<2> field(shear());
  const Vector<Rational, 2> middle{ratio(1, 5), ratio(2, 5)};
  const RoundingGuard guard;
  const auto box = field.within(middle, {ratio(1, 50), ratio(1, 20)});
  for (const long a : {-1, 0, 1}) {
    for (const long b : {-1, 0, 1}) {
      const auto g = field.at<Interval>({middle[0] + ratio(a, 50), middle[1] + ratio(b, 20)});
      for (std::size_t row = 0; row < 2; ++row) {
        for (std::size_t column = 0; column < 2; ++column) {
          EXPECT_LE(box[row][column].lower(), g[row][column].lower());
          EXPECT_GE(box[row][column].upper(), g[row][column].upper());
        }
      }
    }
  }
}

TEST(MetricField, bounds_its_eigenvalues) {
  const auto bounds = MetricField<2>(hills(2, ratio(1, 4))).eigenvalue_bounds();
  EXPECT_LE(bounds.lower, ratio(3, 4));
  EXPECT_GE(bounds.lower, ratio(7, 10));
  EXPECT_GE(bounds.upper, ratio(5, 4));
  EXPECT_LE(bounds.upper, ratio(13, 10));
  const auto flat = MetricField<3>(constant_field(multiple_of_identity(3, Rational(9)))).eigenvalue_bounds();
  EXPECT_LE(flat.lower, Rational(9));
  EXPECT_GE(flat.upper, Rational(9));
  EXPECT_GE(flat.lower, Rational(8));
  EXPECT_LE(flat.upper, Rational(10));
}

TEST(MetricField, is_positive_definite_everywhere_or_refused) {
  EXPECT_NO_THROW(MetricField<2>(hills(2, ratio(99, 100))));
  const std::string message = message_of<Rejection>([] { (void)MetricField<2>(hills(2, ratio(101, 100))); });
  EXPECT_EQ(message, "hills: the metric is not certainly positive definite everywhere");
  // Where it is degenerate somewhere no box tells.
  EXPECT_THROW((void)MetricField<2>(hills(2, Rational(1))), Rejection);
  EXPECT_THROW((void)MetricField<2>(constant_field({{Rational(1), Rational(2)}, {Rational(2), Rational(1)}})),
               Rejection);
}

TEST(MetricField, has_symmetric_matrices_of_its_dimension) {
  EXPECT_THROW((void)MetricField<3>(hills(2, ratio(1, 4))), InputError);
  EXPECT_EQ(message_of<InputError>([] {
              (void)MetricField<2>(constant_field({{Rational(1), Rational(1)}, {Rational(0), Rational(1)}}));
            }),
            "the constant term is not symmetric: rows 1 and 2");
  auto wrong = shear();
  wrong.waves[1].sine = zero_matrix(3);
  EXPECT_EQ(message_of<InputError>([&] { (void)MetricField<2>(wrong); }),
            "the sine matrix of wave 2 is not a matrix of 2 rows of as many numbers");
}

TEST(MetricField, compares_quadratic_forms) {
  const Matrix<Rational, 2> a{{{Rational(2), Rational(1)}, {Rational(1), Rational(2)}}};  // eigenvalues 1 and 3
  const Matrix<Rational, 2> one{{{Rational(1), Rational(0)}, {Rational(0), Rational(1)}}};
  EXPECT_TRUE(is_proved(is_above(a, ratio(99, 100), one)));
  EXPECT_TRUE(is_refuted(is_above(a, Rational(1), one)));
  EXPECT_TRUE(is_proved(is_below(a, ratio(301, 100), one)));
  EXPECT_TRUE(is_refuted(is_below(a, Rational(3), one)));
  // Eigenvalues 2 − √2, 2 and 2 + √2 = 3.41….
  const Matrix<Rational, 3> b{{{Rational(2), Rational(1), Rational(0)},
                               {Rational(1), Rational(2), Rational(1)},
                               {Rational(0), Rational(1), Rational(2)}}};
  Matrix<Rational, 3> unit{};
  for (std::size_t axis = 0; axis < 3; ++axis) unit[axis][axis] = Rational(1);
  EXPECT_TRUE(is_proved(is_positive_definite(b)));
  EXPECT_TRUE(is_proved(is_above(b, ratio(58, 100), unit)));
  EXPECT_TRUE(is_refuted(is_above(b, ratio(59, 100), unit)));
  EXPECT_TRUE(is_proved(is_below(b, ratio(342, 100), unit)));
  EXPECT_TRUE(is_refuted(is_below(b, ratio(341, 100), unit)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
