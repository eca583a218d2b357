#include "kernel/perturb/rounded_frame.hpp"

#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Distances of places are those of points, up to their errors.
template <int m>
void check(const FlatSpace<m>& space, double length) {
  const auto points = random_points<m>(20, 9);
  const auto exact = space.metric.template on<Rational>();
  const FilterGuard guard;
  RoundedFrame<m> frame(space.metric.template on<Filter>(), space.metric.gram());
  frame.measure_by(length);
  EXPECT_GE(length * frame.scale(), 0.5);
  EXPECT_LT(length * frame.scale(), 1);
  const auto enclosure = [](const Vector<Rational, m>& x) {
    Vector<Filter, m> result;
    for (std::size_t axis = 0; axis < m; ++axis) result[axis] = scalar_from<Filter>(x[axis]);
    return result;
  };
  frame.look_about(enclosure(points[0]));
  const auto home = frame.place(enclosure(points[0]));
  const auto as_vector = frame.vector(enclosure(points[1]));
  EXPECT_GE(as_vector.error, 0);
  const Rational scale = Rational::exactly(frame.scale());
  for (const auto& x : points) {
    const auto place = frame.place(enclosure(x));
    EXPECT_LE(place.error, 1e-13 * std::max(1.0, frame.scale()));
    Rational squared(0);
    Rational error = Rational::exactly(place.error + home.error) * Rational(m);
    for (std::size_t axis = 0; axis < m; ++axis)
      squared += square(Rational::exactly(place.at[axis]) - Rational::exactly(home.at[axis]));
    const Rational length_there = square_root_upper(squared, 80);
    const Rational truth = square(scale) * exact.squared_norm(difference(x, points[0]));
    EXPECT_LE(square(maximum(length_there - error - Rational::power_of_two(-70), Rational(0))), truth);
    EXPECT_GE(square(length_there + error), truth);
    // The twin: without the scale this is false.
    if (frame.scale() != 1 && truth > Rational(0)) {
      EXPECT_FALSE(square(length_there + error) >= truth / square(scale) &&
                   square(length_there - error) <= truth / square(scale));
    }
  }
}

TEST(RoundedFrame, has_the_distances_of_the_metric) {
  check<1>(cubic_torus<1>(), 1.0 / 7);
  check<2>(hexagonal_torus(), 3e-5);
  check<2>(square_torus_in_a_long_basis(), 1.0 / 16);
  check<3>(skewed_torus(), 20);
  check<4>(cubic_torus<4>(), 1.0 / 3);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
