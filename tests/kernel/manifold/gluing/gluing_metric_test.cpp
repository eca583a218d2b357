#include "kernel/manifold/gluing/gluing_metric.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernel/manifold/gluing/atlas_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(GluingMetric, is_flat_where_transitions_are_translations) {
  const ChartGluing gluing(atlas_named("torus-2-by-charts"));
  GluingMetric<2> metric(gluing);
  for (const double x : {-0.4, -0.1, 0.0, 0.3125}) {
    const auto inverse = metric.inverse_at({0, {x, 0.25}});
    EXPECT_EQ(inverse, (Matrix<double, 2>{{{1, 0}, {0, 1}}})) << x;
  }
}

/// vᵀG⁻¹v.
template <std::size_t m>
double form(const std::array<std::array<double, m>, m>& a, const std::array<double, m>& v) {
  double result = 0;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) result += v[row] * a[row][column] * v[column];
  }
  return result;
}

TEST(GluingMetric, is_the_same_in_all_charts) {
  const ChartGluing gluing(atlas_named("sphere-3-stereographic"));
  GluingMetric<3> metric(gluing);
  const Vector<double, 3> x{0.6, -0.5, 0.4};
  const double squared = pairing(x, x);
  const ChartPoint<3> there{1, scaled(1 / squared, x)};
  // A covector w there is wᵀDτ here, τ = x/|x|².
  const Vector<double, 3> w{0.3, 0.7, -0.2};
  Vector<double, 3> here;
  for (std::size_t k = 0; k < 3; ++k) here[k] = w[k] / squared - 2 * x[k] * pairing(w, x) / (squared * squared);
  EXPECT_NEAR(form(metric.inverse_at({0, x}), here), form(metric.inverse_at(there), w), 1e-12);
  EXPECT_GT(std::fabs(form(metric.inverse_at({0, x}), w) - form(metric.inverse_at(there), w)), 1e-3);
  // G is what it says.
  const auto gram = metric.enclosed_at({0, x});
  const auto inverse = metric.inverse_at({0, x});
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      double entry = 0;
      for (std::size_t k = 0; k < 3; ++k) entry += gram[row][k].lower() * inverse[k][column];
      EXPECT_NEAR(entry, row == column ? 1 : 0, 1e-12);
    }
  }
}

TEST(GluingMetric, finds_the_places_of_a_point) {
  const ChartGluing gluing(atlas_named("sphere-2-stereographic"));
  GluingMetric<2> metric(gluing);
  EXPECT_EQ(metric.places_of({0, {0.25, 0.25}}).size(), 1U);
  const auto places = metric.places_of({0, {1.25, 1.25}});
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[1].chart, 1U);
  EXPECT_NEAR(places[1].x[0], 0.4, 1e-15);
  // Deep there, near the rim here; and back again.
  EXPECT_EQ(metric.deepest_place_of({0, {1.25, 1.25}}).chart, 1U);
  EXPECT_EQ(metric.deepest_place_of({1, places[1].x}).chart, 1U);
  EXPECT_EQ(metric.deepest_place_of({0, {0.25, 0.25}}).chart, 0U);
}

TEST(GluingMetric, heeds_conditions) {
  auto description = atlas_named("sphere-2-stereographic");
  description.transitions[0].where = {"x"};
  const ChartGluing gluing(description);
  GluingMetric<2> metric(gluing);
  EXPECT_EQ(metric.places_of({0, {1, 1}}).size(), 2U);
  EXPECT_EQ(metric.places_of({0, {-1, 1}}).size(), 1U);
  EXPECT_EQ(metric.places_of({1, {1, 1}}).size(), 2U);
  EXPECT_EQ(metric.places_of({1, {-1, 1}}).size(), 1U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
