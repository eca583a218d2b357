#include "kernel/theorems/barycentric_form.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernel/number/rounding_guard.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// A square of numbers that are quadratic in barycentric coordinates, and its determinant at a point.
template <int m>
struct Quadratic {
  static constexpr auto n = static_cast<std::size_t>(m);
  std::array<std::array<std::array<double, n + 1>, n + 1>, n * n> of{};  // of t_k t_l, k ≤ l

  [[nodiscard]] double entry(std::size_t at, const std::array<double, n + 1>& t) const {
    double value = 0;
    for (std::size_t k = 0; k <= n; ++k) {
      for (std::size_t l = k; l <= n; ++l) value += of[at][k][l] * t[k] * t[l];
    }
    return value;
  }
  [[nodiscard]] double determinant_at(const std::array<double, n + 1>& t) const {
    const auto a = [&](std::size_t row, std::size_t column) { return entry(row * n + column, t); };
    if constexpr (m == 2) {
      return a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    } else {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += a(0, k) * (a(1, (k + 1) % 3) * a(2, (k + 2) % 3) - a(1, (k + 2) % 3) * a(2, (k + 1) % 3));
      return sum;
    }
  }
  [[nodiscard]] FormMatrix<m> forms() const {
    FormMatrix<m> result(n * n, BarycentricForm<m>(2));
    for (std::size_t at = 0; at < n * n; ++at) {
      for (std::size_t k = 0; k <= n; ++k) {
        for (std::size_t l = k; l <= n; ++l) result[at].of_pair(k, l) = Interval::exactly(of[at][k][l]);
      }
    }
    return result;
  }
};

template <int m>
void expect_bounds_below_values() {
  constexpr auto n = static_cast<std::size_t>(m);
  std::mt19937_64 random(m);
  std::uniform_real_distribution<double> coefficient(-1, 1);
  std::exponential_distribution<double> weight;
  for (int round = 0; round < 50; ++round) {
    Quadratic<m> square;
    for (auto& entry : square.of) {
      for (auto& row : entry) {
        for (double& x : row) x = coefficient(random);
      }
    }
    const RoundingGuard guard;
    const double bound = determinant<m>(square.forms()).least_control();
    for (int k = 0; k < 100; ++k) {
      std::array<double, n + 1> t{};
      double whole = 0;
      for (double& x : t) whole += x = weight(random);
      for (double& x : t) x /= whole;
      EXPECT_GE(square.determinant_at(t), bound - 1e-9);
    }
  }
}

TEST(BarycentricForm, bounds_determinants_from_below) {
  expect_bounds_below_values<2>();
  expect_bounds_below_values<3>();
}

TEST(BarycentricForm, has_the_value_at_a_corner_for_its_bound_if_it_is_least_there) {
  const RoundingGuard guard;
  // 2 t_0² + 3 (2 t_0 t_1 + 2 t_0 t_2) + 4 (t_1 + t_2)²: from 2 to 4.
  BarycentricForm<2> form(2);
  form.of_pair(0, 0) = Interval(2);
  for (std::size_t k = 1; k <= 2; ++k) form.of_pair(k, 0) = Interval(6);
  form.of_pair(1, 1) = form.of_pair(2, 2) = Interval(4);
  form.of_pair(1, 2) = Interval(8);
  EXPECT_EQ(form.least_control(), 2);
  EXPECT_EQ(product(form, form).least_control(), 4);
  EXPECT_EQ(product(form, form).degree(), 4U);
}

TEST(BarycentricForm, of_a_constant_and_of_a_difference) {
  const RoundingGuard guard;
  const auto constant = [](int value) {
    BarycentricForm<3> form(2);
    for (std::size_t k = 0; k <= 3; ++k) {
      for (std::size_t l = k; l <= 3; ++l) form.of_pair(k, l) = Interval(k == l ? value : 2 * value);
    }
    return form;
  };
  FormMatrix<3> square(9, constant(1));
  for (std::size_t k = 0; k < 3; ++k) square[4 * k] = constant(2);
  EXPECT_NEAR(determinant<3>(square).least_control(), 4, 1e-12);  // of 1 + (1, 1, 1)ᵀ(1, 1, 1)
  BarycentricForm<3> none = constant(5);
  none -= constant(5);
  EXPECT_EQ(none.least_control(), 0);
  none += constant(3);
  EXPECT_EQ(none.least_control(), 3);
}

TEST(BarycentricForm, is_lossless_where_one_direction_is_stretched) {
  const RoundingGuard guard;
  // 1 + c(t) nᵀ has the determinant 1 + c·n, whatever else c is: here c·n is from −1/2 to 0.
  Quadratic<2> square;
  const std::array<double, 2> normal = {1024, 0};
  for (std::size_t k = 0; k <= 2; ++k) {
    for (std::size_t l = k; l <= 2; ++l) {
      const double twice = k == l ? 1 : 2;
      const std::array<double, 2> c = {-twice * static_cast<double>(k + l) / 8192, twice * 50 * static_cast<double>(k)};
      for (std::size_t at = 0; at < 4; ++at)
        square.of[at][k][l] = c[at / 2] * normal[at % 2] + (at % 3 == 0 ? twice : 0);
    }
  }
  EXPECT_EQ(determinant<2>(square.forms()).least_control(), 0.5);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
