#include "kernel/manifold/gluing/affine_chart.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Matrix<Rational, 3> triangle{{{Rational(2), ratio(1, 3), Rational(-1)},
                                    {Rational(0), ratio(1, 2), Rational(4)},
                                    {Rational(0), Rational(0), Rational(3)}}};

TEST(AffineChart, inverts_its_matrix) {
  const AffineChart<3> chart(triangle);
  for (std::size_t column = 0; column < 3; ++column) {
    Vector<Rational, 3> unit{};
    unit[column] = Rational(1);
    EXPECT_EQ(upper_applied(chart.matrix(), upper_applied(chart.inverse(), unit)), unit);
    EXPECT_EQ(upper_applied(chart.inverse(), upper_applied(chart.matrix(), unit)), unit);
  }
}

TEST(AffineChart, has_the_gram_matrix_of_its_columns_and_stretches_of_the_inverse) {
  const AffineChart<3> chart(triangle);
  const auto gram = chart.gram();
  const Vector<Rational, 3> x{Rational(1), Rational(-2), ratio(1, 2)};
  const auto image = upper_applied(chart.matrix(), x);
  Rational length(0);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(gram[row][(row + 1) % 3], gram[(row + 1) % 3][row]);
    length += x[row] * pairing(gram[row], x);
  }
  EXPECT_EQ(length, pairing(image, image));
  // (B⁻¹)_kk is the least number with x_k² ≤ (B⁻¹)_kk |Ax|²: there is equality for x = B⁻¹e_k.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_LE(square(x[axis]), chart.squared_stretch(axis) * length);
    Vector<Rational, 3> column;  // of A⁻ᵀ, so that A⁻¹ of it is B⁻¹e_k
    for (std::size_t k = 0; k < 3; ++k) column[k] = chart.inverse()[axis][k];
    const auto best = upper_applied(chart.inverse(), column);
    EXPECT_EQ(square(best[axis]), chart.squared_stretch(axis) * pairing(column, column));
  }
}

TEST(AffineChart, is_upper_triangular_with_a_positive_diagonal) {
  auto wrong = triangle;
  wrong[2][2] = Rational(0);
  EXPECT_EQ(message_of<InputError>([&] { (void)AffineChart<3>(wrong); }),
            "the matrix of a chart has 0 on its diagonal");
  wrong = triangle;
  wrong[2][0] = Rational(1);
  EXPECT_EQ(message_of<InputError>([&] { (void)AffineChart<3>(wrong); }),
            "the matrix of a chart is not upper triangular");
}

TEST(AffineChart, is_a_cholesky_factor_up_to_rounding) {
  const MetricField<2> field(shear());
  for (const long at : {1, 2, 5}) {
    const auto gram = [&] {
      const RoundingGuard guard;
      return field.at<Interval>({ratio(at, 7), ratio(3, 7)});
    }();
    const auto chart = rounded_chart<2>(gram);
    const RoundingGuard guard;
    const auto back = matrix_on<Interval>(chart.gram());
    const Rational eta = Rational::power_of_two(-27);
    EXPECT_TRUE(is_proved(is_above(back, scalar_from<Interval>(Rational(1) - eta), gram)));
    EXPECT_TRUE(is_proved(is_below(back, scalar_from<Interval>(Rational(1) + eta), gram)));
    // 30 binary digits are not many more than it takes.
    for (std::size_t row = 0; row < 2; ++row) {
      for (std::size_t column = row; column < 2; ++column)
        EXPECT_LE(chart.matrix()[row][column].denominator(), Integer(1) << 31);
    }
    const Rational finer = Rational::power_of_two(-36);
    EXPECT_FALSE(is_proved(is_above(back, scalar_from<Interval>(Rational(1) - finer), gram)) &&
                 is_proved(is_below(back, scalar_from<Interval>(Rational(1) + finer), gram)));
  }
}

TEST(AffineChart, of_squares_is_exact) {
  Matrix<Interval, 3> gram{};
  gram[0][0] = Interval(4);
  gram[1][1] = Interval(9);
  gram[2][2] = Interval(1);
  const auto chart = rounded_chart<3>(gram);
  EXPECT_EQ(chart.matrix()[0][0], Rational(2));
  EXPECT_EQ(chart.matrix()[1][1], Rational(3));
  EXPECT_EQ(chart.matrix()[2][2], Rational(1));
  EXPECT_EQ(chart.matrix()[0][2], Rational(0));
  gram[2][2] = Interval(-1);
  EXPECT_THROW((void)rounded_chart<3>(gram), Rejection);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
