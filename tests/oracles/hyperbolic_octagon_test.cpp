// The Bolza surface: CGAL's periodic hyperbolic Delaunay triangulation, on the octagon with angles π/4 whose opposite
// sides are paired by translations, against the certified complex.

#include <CGAL/Periodic_4_hyperbolic_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_4_hyperbolic_Delaunay_triangulation_traits_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "tests/oracles/space_form_sample.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Traits = CGAL::Periodic_4_hyperbolic_Delaunay_triangulation_traits_2<>;
using Triangulation = CGAL::Periodic_4_hyperbolic_Delaunay_triangulation_2<Traits>;

struct DiskPoint {
  double x;
  double y;
};

/// The image in the octagon, in Poincaré's disk. Both octagons have the middles of their sides at the angles kπ/4; a
/// perturbed point may be outside, and the translation that pairs the side next to it takes it back.
DiskPoint in_octagon(const ModelPoint<Rational, 2>& exact) {
  double x[3];
  for (std::size_t axis = 0; axis < 3; ++axis) x[axis] = approximate_double(exact[axis]);
  // Twice the inradius ρ, cosh ρ = cot π/8 = 1 + √2.
  const double cosine = 2 * std::pow(1 + std::numbers::sqrt2, 2) - 1;
  const double sine = std::sqrt(cosine * cosine - 1);
  for (int side = 0; side < 8; ++side) {
    const double along[2] = {std::cos(side * std::numbers::pi / 4), std::sin(side * std::numbers::pi / 4)};
    const double height = x[1] * along[0] + x[2] * along[1];
    const double moved = cosine * x[0] - sine * height;  // cosh of the distance from the centre beyond that side
    if (moved >= x[0]) continue;
    const double change = cosine * height - sine * x[0] - height;
    x[0] = moved;
    x[1] += change * along[0];
    x[2] += change * along[1];
    side = -1;
  }
  return {x[1] / (1 + x[0]), x[2] / (1 + x[0])};
}

/// The label of the point that is this one but for the rounding of exact numbers to doubles.
std::uint32_t label_at(const std::vector<DiskPoint>& points, const Traits::Point_2& point) {
  const double x = CGAL::to_double(point.x());
  const double y = CGAL::to_double(point.y());
  const auto distance = [&](const DiskPoint& other) { return std::hypot(other.x - x, other.y - y); };
  const auto nearest = std::min_element(points.begin(), points.end(), [&](const auto& one, const auto& other) {
    return distance(one) < distance(other);
  });
  EXPECT_LT(distance(*nearest), 1e-14);
  return static_cast<std::uint32_t>(nearest - points.begin());
}

LabelComplex<2> cgal_complex_on_octagon(const SpaceFormSample<2>& sample) {
  std::vector<DiskPoint> points;
  std::vector<Traits::Point_2> input;
  for (std::uint32_t label = 0; label < sample.atlas.size(); ++label) {
    points.push_back(in_octagon(model_position<2>(sample, Label(label))));
    input.emplace_back(points.back().x, points.back().y);
  }
  Triangulation triangulation;
  triangulation.insert(input.begin(), input.end());
  // The dummy points with which it begins are gone, and no point was outside of the octagon.
  EXPECT_EQ(triangulation.number_of_dummy_points(), 0);
  EXPECT_EQ(triangulation.number_of_vertices(), sample.atlas.size());
  std::map<Triangulation::Vertex_handle, std::uint32_t> label_of;
  for (auto vertex = triangulation.vertices_begin(); vertex != triangulation.vertices_end(); ++vertex)
    label_of[vertex] = label_at(points, vertex->point());
  LabelComplex<2> result;
  for (auto face = triangulation.faces_begin(); face != triangulation.faces_end(); ++face) {
    result.push_back({label_of.at(face->vertex(0)), label_of.at(face->vertex(1)), label_of.at(face->vertex(2))});
  }
  sort_simplices<2>(result);
  return result;
}

TEST(HyperbolicOctagon, has_the_complex_of_the_bolza_surface) {
  const auto sample = certified_sample<2>("bolza-surface", Rational(Integer(3), Integer(20)));
  expect_same_labels<2>(sample.run.complex.simplices(), cgal_complex_on_octagon(sample));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
