#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/manifold/submanifold/mesh_evaluation.hpp"
#include "kernel/manifold/submanifold/mesh_neighbours.hpp"
#include "kernel/manifold/submanifold/mesh_sampler.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

namespace {

std::vector<Interval> enclosed_points(const TriangleMesh& mesh) {
  const RoundingGuard guard;
  std::vector<Interval> result;
  for (const auto& point : mesh.points) {
    for (const Rational& x : point) result.push_back(scalar_from<Interval>(x));
  }
  return result;
}

std::vector<SpaceBox> boxes_of(const TriangleMesh& mesh, const std::vector<Interval>& places) {
  std::vector<SpaceBox> result;
  for (const auto& triangle : mesh.triangles) {
    SpaceBox& box = result.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::numeric_limits<double>::infinity();
      box.upper[axis] = -box.lower[axis];
      for (const std::uint32_t vertex : triangle) {
        const Interval& x = places[3 * std::size_t{vertex} + axis];
        box.lower[axis] = std::min(box.lower[axis], x.lower());
        box.upper[axis] = std::max(box.upper[axis], x.upper());
      }
    }
  }
  return result;
}

std::vector<std::array<Rational, 2>> box_around(const TriangleMesh& mesh) {
  std::vector<std::array<Rational, 2>> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Rational least = mesh.points[0][axis];
    Rational greatest = least;
    for (const auto& point : mesh.points) {
      least = std::min(least, point[axis]);
      greatest = std::max(greatest, point[axis]);
    }
    const Rational room = (greatest - least) * Rational::power_of_two(-4) + Rational::power_of_two(-20);
    result.push_back({least - room, greatest + room});
  }
  return result;
}

double cosine_between(const PolyhedralMesh& mesh, std::uint32_t one, std::uint32_t other) {
  const auto normal = [&](std::uint32_t facet) {
    std::array<std::array<double, 3>, 2> edge{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < 2; ++k)
        edge[k][axis] = mesh.point(facet, k + 1)[axis].lower() - mesh.point(facet, 0)[axis].lower();
    }
    return std::array{edge[0][1] * edge[1][2] - edge[0][2] * edge[1][1],
                      edge[0][2] * edge[1][0] - edge[0][0] * edge[1][2],
                      edge[0][0] * edge[1][1] - edge[0][1] * edge[1][0]};
  };
  const auto a = normal(one);
  const auto b = normal(other);
  const auto product = [](const auto& x, const auto& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; };
  return product(a, b) / std::sqrt(product(a, a) * product(b, b));
}

}  // namespace

PolyhedralMesh::PolyhedralMesh(std::string name, TriangleMesh mesh, std::vector<std::string> homology)
    : name_(std::move(name)),
      mesh_(std::move(mesh)),
      homology_(std::move(homology)),
      neighbours_(neighbours_if_closed(name_, mesh_)),
      places_(enclosed_points(mesh_)),
      box_(box_around(mesh_)),
      tree_(boxes_of(mesh_, places_)) {}

std::unique_ptr<GraphEvaluation> PolyhedralMesh::evaluation() const { return mesh_evaluation(*this); }

std::unique_ptr<ManifoldSampler> PolyhedralMesh::sampler(double radius) const { return mesh_sampler(*this, radius); }

std::string PolyhedralMesh::crease_near(std::uint32_t facet) const {
  constexpr std::size_t most_looked_at = 200;
  std::vector<std::uint32_t> around{facet};
  double least = 1;
  std::array<std::uint32_t, 2> sharpest{};
  for (std::size_t at = 0; at < around.size() && around.size() < most_looked_at; ++at) {
    for (const std::uint32_t other : neighbours(around[at])) {
      const double cosine = cosine_between(*this, around[at], other);
      if (cosine < least) {
        least = cosine;
        sharpest = {around[at], other};
      }
      if (std::find(around.begin(), around.end(), other) == around.end()) around.push_back(other);
    }
  }
  char cosine[32];
  std::snprintf(cosine, sizeof cosine, "%.3f", least);
  return "the sharpest crease near by is between the facets " + std::to_string(std::min(sharpest[0], sharpest[1])) +
         " and " + std::to_string(std::max(sharpest[0], sharpest[1])) + ", whose normals have the cosine " + cosine +
         ": smooth the mesh there, or, if it is only curved, take a smaller sampling radius";
}

}  // namespace delcert
