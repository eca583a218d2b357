#include "kernel/sample/graded_density.hpp"

#include "kernel/sample/poisson_disk.hpp"
#include "support/error.hpp"
#include "tests/kernel/stars/witness.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Finer about (1/2, …).
template <int m>
TorusSizing<m> finer_in_the_middle(const FlatSpace<m>& space, double greatest, double least, double slope) {
  TorusSizing<m> result(space, greatest);
  result.add({std::vector<double>(m, 0.5), least, slope});
  return result;
}

template <int m>
SamplingRadii proportions_of(const ExactPoints<m>& points, const TorusSizing<m>& sizing) {
  std::vector<double> radii;
  for (const auto& point : points) radii.push_back(sizing.at(approximate<m>(point)));
  return SamplingRadii(radii);
}

/// The greatest |ε_i − ε_j|/min of lifts that are closer than 9(1 + ε₀)max, exactly.
template <int m>
Rational variation_of(const FlatSpace<m>& space, const ExactPoints<m>& points, const GradedDensity<m>& density) {
  const Rational factor = Rational(9) * (Rational(1) + density.radius_variation);
  Rational result(0);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Rational& own = density.radii.of(i);
    for (const auto& lift : lifts_within<m>(space, points, points[i], factor * own)) {
      const Rational& other = density.radii.of(lift.index);
      if (other < own) result = maximum(result, (own - other) / other);
    }
  }
  return result;
}

template <int m>
Rational least_of(const GradedDensity<m>& density, const LiftedSimplex<m>& simplex) {
  Rational result = density.radii.greatest();
  for (const auto& vertex : simplex) result = minimum(result, density.radii.of(vertex.index));
  return result;
}

template <int m>
void check_graded(const FlatSpace<m>& space, double greatest, double least) {
  const auto sizing = finer_in_the_middle<m>(space, greatest, least, 1.0 / 100);
  const auto points = poisson_disk_net<m>(space, sizing, 1, no_progress());
  const auto proportions = proportions_of<m>(points, sizing);
  ASSERT_TRUE(proportions.vary());
  const auto density = measure_graded_density<m>(space, PointSet<m>(points), proportions, no_progress());
  EXPECT_EQ(density.radii.units(), proportions.units());
  EXPECT_GT(density.radius_variation, Rational(0));
  EXPECT_LE(variation_of<m>(space, points, density), density.radius_variation);
  // It is not much more: the grid sees points that are a little farther.
  EXPECT_GE(variation_of<m>(space, points, density) + Rational::power_of_two(-10), density.radius_variation);
  const auto complaint = [&](const Rational& factor) {
    return complaint_of_torus_cover<m>(space, points, density.simplices, [&](const auto& simplex) {
      return factor * least_of<m>(density, simplex) / (Rational(1) + density.radius_variation);
    });
  };
  EXPECT_EQ(complaint(Rational(1)), "");
  EXPECT_EQ(complaint(ratio(999, 1000)), "0.ball");
  // Nearly that of the net.
  const double expected = greatest * approximate_double(Rational(1) + density.radius_variation);
  EXPECT_LE(approximate_double(density.radii.greatest()), expected * 1.002);
}

TEST(GradedDensity, is_dense_and_varies_as_it_says) {
  check_graded<1>(cubic_torus<1>(), 1.0 / 40, 1.0 / 43);
  check_graded<2>(cubic_torus<2>(), 1.0 / 10, 1.0 / 11);
  check_graded<2>(hexagonal_torus(), 1.0 / 10, 1.0 / 11);
  check_graded<3>(cubic_torus<3>(), 1.0 / 4, 1.0 / 4.125);
}

TEST(GradedDensity, of_radii_that_are_all_the_same_has_no_variation) {
  const auto space = cubic_torus<2>();
  const auto points = poisson_disk_net<2>(space, ratio(1, 10), 1, no_progress());
  const auto density = measure_graded_density<2>(space, PointSet<2>(points), ratio(1, 10), no_progress());
  EXPECT_FALSE(density.radii.vary());
  EXPECT_EQ(density.radius_variation, Rational(0));
  EXPECT_EQ(complaint_of_torus_witness<2>(space, points, density.simplices, density.radii.greatest()), "");
}

TEST(GradedDensity, refuses_radii_that_vary_too_much) {
  const auto space = cubic_torus<2>();
  const auto refusal = [&](double slope) {
    const auto sizing = finer_in_the_middle<2>(space, 1.0 / 16, 1.0 / 50, slope);
    const auto points = poisson_disk_net<2>(space, sizing, 1, no_progress());
    return message_of<Rejection>([&] {
      (void)measure_graded_density<2>(space, PointSet<2>(points), proportions_of<2>(points, sizing), no_progress());
    });
  };
  EXPECT_TRUE(mentions(refusal(1.0 / 10), "radii vary too much"));
  EXPECT_EQ(refusal(1.0 / 64), "accepted");
}

TEST(GradedDensity, refuses_too_few_points) {
  EXPECT_TRUE(mentions(message_of<Rejection>([] {
                         (void)measure_graded_density<2>(cubic_torus<2>(), PointSet<2>(random_points<2>(2, 1)),
                                                         ratio(1, 10), no_progress());
                       }),
                       "more than 2 points"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
