#include "kernel/sample/affine_net.hpp"

#include <gtest/gtest.h>

#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The square torus, all points in one heap.
class HeapTorus {
 public:
  using Place = Vector<double, 2>;
  static Place random_place(CounterRandom& random) {
    Place x;
    for (double& coordinate : x) coordinate = random.next_unit();
    return on_net_grid<2>(x);
  }
  static Place moved(const Place& x, const Vector<double, 2>& offset) {
    Place result = on_net_grid<2>(sum(x, offset));
    for (double& coordinate : result) coordinate -= std::floor(coordinate);
    return result;
  }
  static const Place& home_of(const Place& x) { return x; }
  static PlainChart<2> chart_at(const Place&) {
    return PlainChart<2>(AffineChart<2>({{{Rational(1), Rational(0)}, {Rational(0), Rational(1)}}}));
  }
  void insert(std::uint32_t, const Place& x, const PlainChart<2>&) { points_.push_back(x); }
  static Vector<double, 2> stretch_about(const Place&) { return {1, 1}; }
  template <class See>
  void visit(const Place& x, const Vector<double, 2>&, const See& see) const {
    const Matrix<double, 2> matrix{{{1, 0}, {0, 1}}};
    for (std::uint32_t index = 0; index < points_.size(); ++index) {
      for (std::int32_t a = -1; a <= 1; ++a) {
        for (std::int32_t b = -1; b <= 1; ++b) {
          const Vector<double, 2> offset{points_[index][0] + a - x[0], points_[index][1] + b - x[1]};
          if (see(Lift<2>{index, {a, b}, 0}, offset, matrix)) return;
        }
      }
    }
  }

 private:
  std::vector<Place> points_;
};

TEST(AffineNet, is_a_maximal_poisson_disk_set) {
  HeapTorus torus;
  AffineNetPoints<2, HeapTorus> points(torus, 0.125);
  const double covering = sample_disks<2>(points, 0.125, 3, no_progress());
  EXPECT_LE(covering, 0.125 * 1.0001);
  const auto& places = points.places();
  EXPECT_GE(places.size(), 40U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double squared = 0;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double along = std::fabs(places[i][axis] - places[j][axis]);
        squared += std::pow(std::min(along, 1 - along), 2);
      }
      EXPECT_GE(squared, 0.125 * 0.125 * (1 - 1e-9));
    }
  }
}

TEST(AffineNet, has_charts_in_doubles) {
  const PlainChart<2> chart(AffineChart<2>({{{Rational(2), Rational(1)}, {Rational(0), Rational(4)}}}));
  EXPECT_EQ(chart.matrix, (Matrix<double, 2>{{{2, 1}, {0, 4}}}));
  EXPECT_EQ(chart.inverse, (Matrix<double, 2>{{{0.5, -0.125}, {0, 0.25}}}));
  EXPECT_EQ(chart.stretch[1], 0.25);
}

TEST(AffineNet, points_are_on_the_grid_of_nets) {
  EXPECT_EQ(on_net_grid<2>(Vector<double, 2>{0x1p-50, 0.5}), (Vector<double, 2>{0, 0.5}));
  EXPECT_EQ(exact_vector<2>(Vector<double, 2>{0.25, -3}), (Vector<Rational, 2>{ratio(1, 4), Rational(-3)}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
