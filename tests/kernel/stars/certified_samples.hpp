#pragma once

#include "kernel/run/chart_run.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"
#include "tests/kernel/stars/curved_patch.hpp"

// Certified complexes to measure.
namespace delcert::test {

inline const ModelGeometry unit_sphere{Curvature::positive, Rational(3)};
inline const ModelGeometry unit_torus{Curvature::zero, ratio(1, 2)};

struct SphereSample {
  CurvedPatch<2> atlas;
  ChartRun<2> run;
  std::vector<Vector<double, 3>> places;  ///< of the perturbed points, in space, without error bounds
};

/// A net of the unit sphere, perturbed, ε = 1/5.
inline SphereSample perturbed_sphere() {
  const auto net = farthest_point_net<2>(Curvature::positive, 0.2, 20000, 1);
  CurvedPatch<2> atlas(Curvature::positive, net, ratio(1, 5));
  auto run = run_in_charts<2>(atlas, unit_sphere, measured_parameters(Dimension(2), 1), {}, no_progress());
  EXPECT_TRUE(run.is_certified());
  std::vector<Vector<double, 3>> places;
  const FilterGuard guard;
  for (std::uint32_t i = 0; i < net.size(); ++i) {
    const auto frame = model_frame<Rational, 2>(Curvature::positive, net[i]);
    const auto point = exponential<Filter, 2>(Curvature::positive, run.points.enclosure(Label(i)));
    Vector<double, 3> place{};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column)
        place[row] += approximate_double(frame[row][column]) * point[column].lower();
    }
    places.push_back(place);
  }
  return {std::move(atlas), std::move(run), std::move(places)};
}

struct TorusSample {
  FlatAtlas<2> atlas;
  ChartRun<2> run;
};

/// A square lattice on the unit torus, perturbed.
inline TorusSample perturbed_torus() {
  std::vector<Vector<Rational, 2>> net;
  for (long a = 0; a < 24; ++a) {
    for (long b = 0; b < 24; ++b) net.push_back({ratio(a, 24), ratio(b, 24)});
  }
  FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(net), ratio(1, 32));
  auto run = run_in_charts<2>(atlas, unit_torus, measured_parameters(Dimension(2), 1), {}, no_progress());
  EXPECT_TRUE(run.is_certified());
  return {std::move(atlas), std::move(run)};
}

}  // namespace delcert::test
