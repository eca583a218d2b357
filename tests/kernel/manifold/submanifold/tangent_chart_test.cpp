#include "kernel/manifold/submanifold/tangent_chart.hpp"

#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TangentChart chart_at(const ZeroSet& m, const std::vector<Rational>& centre) {
  FormulaEvaluation<double> f(m.map());
  return tangent_chart(m, f, centre);
}

bool is_orthogonal(const Dense<Rational>& frame, std::size_t n) {
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < n; ++column) {
      Rational sum(0);
      for (std::size_t k = 0; k < n; ++k) sum += frame[k * n + row] * frame[k * n + column];
      if (sum != Rational(row == column ? 1 : 0)) return false;
    }
  }
  return true;
}

TEST(TangentChart, frames_are_orthogonal_exactly_whatever_the_skew_matrix) {
  ChartData data;
  data.centre = std::vector<Rational>(4, Rational(0));
  data.columns = {-3, 1, 4, -2};
  data.skew = {ratio(3, 7), ratio(-1, 2), Rational(5), ratio(1, 8), Rational(0), ratio(-9, 4)};
  data.preconditioner = {Rational(1), Rational(0), Rational(0), Rational(1)};
  auto frame = TangentChart(data, 2).frame();
  EXPECT_TRUE(is_orthogonal(frame, 4));
  frame[5] += Rational::power_of_two(-60);
  EXPECT_FALSE(is_orthogonal(frame, 4));
}

TEST(TangentChart, is_nearly_tangent_with_short_numbers) {
  const ZeroSet m = clifford_torus();
  const std::vector<Rational> centre{ratio(3, 5), ratio(-4, 5), ratio(-5, 13), ratio(12, 13)};
  const TangentChart chart = chart_at(m, centre);
  const auto frame = chart.frame();
  ASSERT_TRUE(is_orthogonal(frame, 4));
  for (const Rational& entry : chart.data().skew) EXPECT_LE(entry.denominator(), Integer(4096));
  // Normals are (a, b, 0, 0) and (0, 0, c, d).
  for (std::size_t k = 0; k < 2; ++k) {
    for (const std::size_t from : {0U, 2U}) {
      const Rational along = frame[from * 4 + k] * centre[from] + frame[(from + 1) * 4 + k] * centre[from + 1];
      EXPECT_LE(absolute(along), ratio(1, 1000));
    }
  }
  // Y·Df·N, exactly.
  for (std::size_t row = 0; row < 2; ++row) {
    for (std::size_t column = 0; column < 2; ++column) {
      Rational sum(0);
      for (std::size_t b = 0; b < 2; ++b) {
        for (std::size_t axis = 2 * b; axis < 2 * b + 2; ++axis)
          sum += chart.data().preconditioner[row * 2 + b] * Rational(2) * centre[axis] * frame[axis * 4 + 2 + column];
      }
      EXPECT_LE(absolute(sum - Rational(row == column ? 1 : 0)), Rational::power_of_two(-16));
    }
  }
}

TEST(TangentChart, encloses_what_it_has) {
  const TangentChart chart = chart_at(torus_of_revolution(), {ratio(13, 5), ratio(1, 100), ratio(4, 5)});
  const auto frame = chart.frame();
  const auto exact = chart.on<Rational>();
  const auto big = chart.on<BigInterval>();
  for (std::size_t at = 0; at < frame.size(); ++at) {
    EXPECT_EQ(exact.frame[at], frame[at]);
    EXPECT_LE(Rational::exactly(chart.enclosed().frame[at].lower()), frame[at]);
    EXPECT_GE(Rational::exactly(chart.enclosed().frame[at].upper()), frame[at]);
    EXPECT_LE(big.frame[at].upper() - big.frame[at].lower(), Rational::power_of_two(-120));
  }
  // There and back.
  const std::vector<Rational> y{ratio(1, 7), ratio(-2, 9), ratio(1, 5)};
  std::vector<Rational> x(3);
  exact.position(y.data(), x.data());
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(exact.coordinate(x.data(), k), y[k]);
}

TEST(TangentChart, refuses_data_that_are_no_chart) {
  ChartData data = polar_chart(Rational(1), Rational(1)).data();
  data.columns = {1, 2, -2};
  EXPECT_THROW((void)TangentChart(data, 2), InputError);
  data.columns = {1, 2, 4};
  EXPECT_THROW((void)TangentChart(data, 2), InputError);
  data.columns = {2, -3, 1};
  EXPECT_NO_THROW((void)TangentChart(data, 2));
  data.skew.pop_back();
  EXPECT_THROW((void)TangentChart(data, 2), InputError);
  EXPECT_EQ(message_of<Rejection>([] {
              (void)chart_at(cone(), {Rational(0), Rational(0), Rational(0)});
            }),
            "cone: the derivatives of the equations are not independent at (0, 0, 0)");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
