#include "proofs/drawing/manifold/dirichlet_wires.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace delcert {

namespace {

using WireVector = Motions::Vector;
constexpr double wall_tolerance = 1e-7;
constexpr int pieces_of_a_wire = 16;

double inner(const WireVector& a, const WireVector& b) {
  double sum = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) sum += a[axis] * b[axis];
  return sum;
}

/// The part orthogonal to orthonormal vectors, of length 1. None if nothing is left.
std::optional<WireVector> orthonormal(WireVector x, const std::vector<WireVector>& basis) {
  const double before = std::sqrt(inner(x, x));
  for (const WireVector& other : basis) {
    const double along = inner(x, other);
    for (std::size_t axis = 0; axis < x.size(); ++axis) x[axis] -= along * other[axis];
  }
  const double length = std::sqrt(inner(x, x));
  if (!(length > 1e-6 * before)) return std::nullopt;
  for (double& entry : x) entry /= length;
  return x;
}

/// A basis of the plane on which m − 1 walls vanish. None if they are dependent.
std::optional<std::array<WireVector, 2>> plane_of(const std::vector<WireVector>& walls, std::size_t m) {
  std::vector<WireVector> basis;
  for (const WireVector& wall : walls) {
    const auto next = orthonormal(wall, basis);
    if (!next) return std::nullopt;
    basis.push_back(*next);
  }
  for (std::size_t axis = 0; axis <= m && basis.size() <= m; ++axis) {
    WireVector unit{};
    unit[axis] = 1;
    if (const auto next = orthonormal(unit, basis)) basis.push_back(*next);
  }
  if (basis.size() != m + 1) return std::nullopt;
  return std::array<WireVector, 2>{basis[m - 1], basis[m]};
}

class WireSearch {
 public:
  WireSearch(const std::vector<WireVector>& walls, std::size_t m, int curvature)
      : walls_(walls), m_(m), curvature_(curvature) {
    if (curvature_ <= 0) {
      // The sheet x₀ > 0.
      WireVector front{};
      front[0] = 1;
      walls_.push_back(front);
    }
    for (WireVector& wall : walls_) {
      const double length = std::sqrt(inner(wall, wall));
      for (double& entry : wall) entry /= length;
    }
  }

  std::vector<std::pair<WireVector, WireVector>> wires(std::size_t count) {
    for (std::size_t first = 0; first < count; ++first) {
      if (m_ == 2) add({walls_[first]});
      for (std::size_t second = first + 1; m_ == 3 && second < count; ++second) add({walls_[first], walls_[second]});
    }
    return std::move(result_);
  }

 private:
  void add(const std::vector<WireVector>& on) {
    const auto plane = plane_of(on, m_);
    if (!plane) return;
    const auto at = [&plane](double angle) {
      WireVector x{};
      for (std::size_t axis = 0; axis < x.size(); ++axis)
        x[axis] = std::cos(angle) * (*plane)[0][axis] + std::sin(angle) * (*plane)[1][axis];
      return x;
    };
    const double turn = 2 * std::acos(-1.0);
    std::vector<double> breaks;
    for (const WireVector& wall : walls_) {
      const double along = inner(wall, (*plane)[0]);
      const double across = inner(wall, (*plane)[1]);
      if (std::hypot(along, across) < wall_tolerance) continue;
      for (const double half : {0.0, turn / 2})
        breaks.push_back(std::fmod(std::atan2(-along, across) + half + 2 * turn, turn));
    }
    if (breaks.empty()) breaks = {0};
    std::sort(breaks.begin(), breaks.end());
    for (std::size_t k = 0; k < breaks.size(); ++k) {
      const double from = breaks[k];
      const double to = k + 1 < breaks.size() ? breaks[k + 1] : breaks[0] + turn;
      if (to - from < 1e-6) continue;
      const WireVector middle = at((from + to) / 2);
      if (std::any_of(walls_.begin(), walls_.end(),
                      [&](const auto& wall) { return inner(wall, middle) < -wall_tolerance; }))
        continue;
      for (int piece = 0; piece < pieces_of_a_wire; ++piece) {
        const auto start = in_model(at(from + (to - from) * piece / pieces_of_a_wire));
        const auto end = in_model(at(from + (to - from) * (piece + 1) / pieces_of_a_wire));
        if (start && end) result_.emplace_back(*start, *end);
      }
    }
  }

  [[nodiscard]] std::optional<WireVector> in_model(WireVector x) const {
    double square = 0;
    for (std::size_t axis = 1; axis <= m_; ++axis) square += x[axis] * x[axis];
    const double form = x[0] * x[0] + curvature_ * square;
    const double length = curvature_ == 0 ? x[0] : std::sqrt(form);
    if (!(length > 1e-9)) return std::nullopt;
    for (double& entry : x) entry /= length;
    return x;
  }

  std::vector<WireVector> walls_;
  std::size_t m_;
  int curvature_;
  std::vector<std::pair<WireVector, WireVector>> result_;
};

}  // namespace

std::vector<std::pair<Motions::Vector, Motions::Vector>> wires_between(const std::vector<Motions::Vector>& walls,
                                                                       std::size_t m, int curvature) {
  return WireSearch(walls, m, curvature).wires(walls.size());
}

}  // namespace delcert
