#include "kernel/manifold/submanifold/mesh_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delcert {

namespace {

using Place = std::array<double, 3>;

Place middle_place(const Interval* x) {
  return {x[0].lower() / 2 + x[0].upper() / 2, x[1].lower() / 2 + x[1].upper() / 2,
          x[2].lower() / 2 + x[2].upper() / 2};
}
Place difference_of(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double product_of(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

class MeshSampler final : public ManifoldSampler {
 public:
  MeshSampler(const PolyhedralMesh& mesh, double radius) : mesh_(mesh), radius_(radius) {
    double sum = 0;
    for (std::uint32_t facet = 0; facet < mesh.mesh().triangles.size(); ++facet) {
      for (std::size_t corner = 0; corner < 3; ++corner)
        corners_[corner].push_back(middle_place(mesh.point(facet, corner)));
      const Place normal = normal_at(facet);
      sum += std::sqrt(product_of(normal, normal));
      areas_.push_back(sum);
    }
  }

  std::vector<double> dart(CounterRandom& random) override {
    const double share = random.next_unit() * areas_.back();
    const auto found = std::upper_bound(areas_.begin(), areas_.end(), share);
    const auto facet = static_cast<std::size_t>(std::min(found, areas_.end() - 1) - areas_.begin());
    double a = random.next_unit();
    double b = random.next_unit();
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    std::vector<double> x;
    for (std::size_t axis = 0; axis < 3; ++axis)
      x.push_back((1 - a - b) * corners_[0][facet][axis] + a * corners_[1][facet][axis] + b * corners_[2][facet][axis]);
    return x;
  }

  /// Along the normal column to the nearest place; without a frame x is on M.
  bool project(std::vector<double>& x, const Dense<double>* frame) override {
    if (frame == nullptr) return true;
    const Place origin{x[0], x[1], x[2]};
    const Place along{(*frame)[2], (*frame)[5], (*frame)[8]};
    double nearest = std::numeric_limits<double>::infinity();
    mesh_.tree().visit(
        [&](const SpaceBox& box) { return distance_squared(box, origin) <= 16 * radius_ * radius_; },
        [&](std::uint32_t facet) {
          const Place normal = normal_at(facet);
          const double rise = product_of(normal, along);
          if (rise == 0) return;
          const double t = product_of(normal, difference_of(corners_[0][facet], origin)) / rise;
          if (!(std::fabs(t) < std::fabs(nearest))) return;
          const Place at{origin[0] + t * along[0], origin[1] + t * along[1], origin[2] + t * along[2]};
          for (std::size_t edge = 0; edge < 3; ++edge) {
            const Place& from = corners_[edge][facet];
            const Place side = difference_of(corners_[(edge + 1) % 3][facet], from);
            if (product_of(cross(side, difference_of(at, from)), normal) < -0x1p-40 * product_of(normal, normal))
              return;
          }
          nearest = t;
        });
    if (!std::isfinite(nearest)) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis] += nearest * along[axis];
    return true;
  }

  std::string advice(const std::vector<double>& point) override {
    const Place x{point[0], point[1], point[2]};
    std::uint32_t nearest = 0;
    for (std::uint32_t facet = 1; facet < areas_.size(); ++facet) {
      if (distance_to(facet, x) < distance_to(nearest, x)) nearest = facet;
    }
    return mesh_.crease_near(nearest);
  }

  /// The mean normal of what is near, as far as it shows the same side as the nearest facet.
  std::optional<Dense<double>> normals(const std::vector<double>& point) override {
    const Place x{point[0], point[1], point[2]};
    std::vector<std::uint32_t> near;
    double reach = radius_ / 2;
    for (int round = 0; near.empty() && round < 60; ++round, reach *= 2) {
      mesh_.tree().visit([&](const SpaceBox& box) { return distance_squared(box, x) <= reach * reach; },
                         [&](std::uint32_t facet) { near.push_back(facet); });
    }
    std::sort(near.begin(), near.end());
    double least = std::numeric_limits<double>::infinity();
    Place first{};
    for (const std::uint32_t facet : near) {
      const double distance = distance_to(facet, x);
      if (distance < least) {
        least = distance;
        first = normal_at(facet);
      }
    }
    Dense<double> result(3, 0);
    for (const std::uint32_t facet : near) {
      const Place normal = normal_at(facet);
      const double cosine =
          product_of(normal, first) / std::sqrt(product_of(normal, normal) * product_of(first, first));
      if (!(cosine > 0.5)) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) result[axis] += normal[axis];
    }
    const double length = std::sqrt(result[0] * result[0] + result[1] * result[1] + result[2] * result[2]);
    for (double& entry : result) entry /= length;
    return result;
  }

 private:
  static Place cross(const Place& a, const Place& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  [[nodiscard]] Place normal_at(std::uint32_t facet) const {
    return cross(difference_of(corners_[1][facet], corners_[0][facet]),
                 difference_of(corners_[2][facet], corners_[0][facet]));
  }
  static double distance_squared(const SpaceBox& box, const Place& x) {
    double result = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double away = std::max({box.lower[axis] - x[axis], x[axis] - box.upper[axis], 0.0});
      result += away * away;
    }
    return result;
  }
  /// Squared, of x to the facet.
  [[nodiscard]] double distance_to(std::uint32_t facet, const Place& x) const {
    const Place normal = normal_at(facet);
    bool is_over = true;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const Place& from = corners_[edge][facet];
      const Place side = difference_of(corners_[(edge + 1) % 3][facet], from);
      const Place offset = difference_of(x, from);
      if (product_of(cross(side, offset), normal) < 0) is_over = false;
      const double t = std::clamp(product_of(offset, side) / product_of(side, side), 0.0, 1.0);
      const Place rest{offset[0] - t * side[0], offset[1] - t * side[1], offset[2] - t * side[2]};
      least = std::min(least, product_of(rest, rest));
    }
    if (!is_over) return least;
    const double height = product_of(difference_of(x, corners_[0][facet]), normal);
    return height * height / product_of(normal, normal);
  }

  const PolyhedralMesh& mesh_;
  double radius_;
  std::array<std::vector<Place>, 3> corners_;
  std::vector<double> areas_;  // sums
};

}  // namespace

std::unique_ptr<ManifoldSampler> mesh_sampler(const PolyhedralMesh& mesh, double radius) {
  return std::make_unique<MeshSampler>(mesh, radius);
}

}  // namespace delcert
