// The covering radius of a torus's net is the largest circumradius of its periodic Delaunay triangulation: by CGAL, in
// CGAL's rationals, against the certified bounds.

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/flat_space.hpp"
#include "kernel/sample/net_measure.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "tests/oracles/cgal_delaunay.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;

CGAL::Gmpq squared_circumradius(const std::array<Vector<CGAL::Gmpq, 2>, 3>& v) {
  const auto point = [](const Vector<CGAL::Gmpq, 2>& x) { return Exact::Point_2(x[0], x[1]); };
  return CGAL::squared_radius(point(v[0]), point(v[1]), point(v[2]));
}
CGAL::Gmpq squared_circumradius(const std::array<Vector<CGAL::Gmpq, 3>, 4>& v) {
  const auto point = [](const Vector<CGAL::Gmpq, 3>& x) { return Exact::Point_3(x[0], x[1], x[2]); };
  return CGAL::squared_radius(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
}

/// The square of the covering radius of points of the unit cell that are doubles.
template <int m>
Rational squared_covering_radius(const Doubles<m>& points) {
  CGAL::Gmpq largest(0);
  for (const auto& cell : CgalTorus<m>(points).cells()) {
    std::array<Vector<CGAL::Gmpq, m>, corner_count<m>> vertices;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      const auto& [point, shift] = cell[corner];
      for (std::size_t axis = 0; axis < m; ++axis)
        vertices[corner][axis] = CGAL::Gmpq(point[axis]) + CGAL::Gmpq(shift[axis]);
    }
    largest = std::max(largest, squared_circumradius(vertices));
  }
  return Rational(Rational::Wrapped(largest.mpq()));
}

template <int m>
void expect_bounds(const std::string& manifold, int n) {
  const FlatSpace<m> space = flat_space_of<m>(find_manifold(manifold));
  const Rational radius(Integer(1), Integer(n));
  const PointSet<m> net(poisson_disk_net<m>(space, radius, 1, no_progress()));
  const Doubles<m> points = net.approximate_all();
  for (std::uint32_t index = 0; index < net.size(); ++index) {
    for (std::size_t axis = 0; axis < m; ++axis) {
      ASSERT_EQ(Rational::exactly(points[index][axis]), net.exact(Label(index))[axis]);
      ASSERT_TRUE(points[index][axis] >= 0 && points[index][axis] < 1);
    }
  }
  const Rational truth = squared_covering_radius<m>(points);
  for (const std::optional<Rational>& nominal : {std::optional<Rational>(radius), std::optional<Rational>()}) {
    const auto density = measure_density<m>(space, net, nominal, no_progress());
    EXPECT_LE(square(density.covering_radius_lower), truth);
    EXPECT_LT(truth, square(density.sampling_radius));
    EXPECT_LT(square(density.sampling_radius), truth * square(Rational(Integer(1001), Integer(1000))));
  }
}

TEST(CoveringRadius, square_torus_1_24) { expect_bounds<2>("torus-2", 24); }
TEST(CoveringRadius, square_torus_1_60) { expect_bounds<2>("torus-2", 60); }
TEST(CoveringRadius, cubic_torus_1_24) { expect_bounds<3>("torus-3", 24); }

TEST(CoveringRadius, leaves_the_bounds_when_a_point_is_moved_by_a_third_of_the_radius) {
  const FlatSpace<2> space = flat_space_of<2>(find_manifold("torus-2"));
  const PointSet<2> net(poisson_disk_net<2>(space, Rational(Integer(1), Integer(24)), 1, no_progress()));
  const auto density = measure_density<2>(space, net, std::nullopt, no_progress());
  const auto bounds_hold = [&density](const Rational& truth) {
    return square(density.covering_radius_lower) <= truth && truth < square(density.sampling_radius);
  };
  const Doubles<2> points = net.approximate_all();
  EXPECT_TRUE(bounds_hold(squared_covering_radius<2>(points)));
  // Most points are far from the largest empty circle; one for which the bounds fail is found by trying.
  const auto with_one_point_moved = [&](std::size_t index) {
    Doubles<2> result = points;
    result[index][0] += approximate_double(density.sampling_radius) / 3;
    return result;
  };
  std::size_t moved = 0;
  while (bounds_hold(squared_covering_radius<2>(with_one_point_moved(moved)))) ASSERT_LT(++moved, points.size());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
