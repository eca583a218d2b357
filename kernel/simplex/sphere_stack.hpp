#pragma once

#include <array>

#include "kernel/number/ladder.hpp"
#include "kernel/simplex/frame_metric.hpp"

namespace delcert {

/// The diametric spheres of the growing simplex v0, v0v1, …, v0…vk in ℝᵐ, one vertex at a time.
///
/// All vectors are relative to v0. With n_k the component of v_k − v0 orthogonal to the earlier edges,
///   c_k = c_{k−1} + (|e|² − 2⟨e, c_{k−1}⟩) / (2|n_k|²) · n_k,   R_k² = R_{k−1}² + (…)²/(4|n_k|²),
/// because c_k must have equal distance to all vertices and lie in their hull. R_k never decreases in k.
/// The last dimension takes n_m along the wedge of the first m−1 edges, which saves the projections.
///
/// On intervals |n_k|² may contain 0: `push` then says undecided, and nothing may be read from that depth on.
/// On rationals `push` says refuted exactly for a degenerate simplex.
template <class S, int m>
class SphereStack {
 public:
  using Point = Vector<S, m>;

  explicit SphereStack(const MetricOn<S, m>& metric) : metric_(&metric) {
    level_[0].centre.fill(S(0));
    level_[0].squared_radius = S(0);
    if constexpr (m == 1) prepare_wedge();
  }

  /// The dimension of the current simplex.
  [[nodiscard]] int dimension() const { return depth_; }

  /// Adds the vertex v0 + edge. Returns whether the simplex stays non-degenerate; unless that is proved, the stack
  /// is left as it was. Precondition: dimension() < m.
  // Flattened, here and below: a call that is not inlined passes its intervals through memory.
  [[gnu::flatten]] Verdict push(const Point& edge, const S& squared_edge) {
    const auto k = static_cast<std::size_t>(depth_ + 1);
    const Level& below = level_[k - 1];
    Level& here = level_[k];
    const S excess = squared_edge - twice(metric_->inner(edge, below.centre));
    if (depth_ + 1 == m) {
      const S slope = metric_->determinant() * pairing(covector_, edge);  // ⟨normal, edge⟩
      const Verdict non_degenerate = negation(is_zero(slope));
      if (!is_proved(non_degenerate)) return non_degenerate;
      const S factor = excess / twice(slope);
      here.centre = sum(below.centre, scaled(factor, normal_));
      here.squared_radius = below.squared_radius + square(factor) * squared_normal_;
      here.squared_altitude = square(slope) / squared_normal_;
    } else {
      here.orthogonal = edge;
      for (std::size_t j = 1; j < k; ++j) {
        const S share = metric_->inner(edge, level_[j].orthogonal) / level_[j].squared_altitude;
        here.orthogonal = difference(here.orthogonal, scaled(share, level_[j].orthogonal));
      }
      here.squared_altitude = metric_->squared_norm(here.orthogonal);
      const Verdict non_degenerate = negation(is_zero(here.squared_altitude));
      if (!is_proved(non_degenerate)) return non_degenerate;
      const S factor = excess / twice(here.squared_altitude);
      here.centre = sum(below.centre, scaled(factor, here.orthogonal));
      here.squared_radius = below.squared_radius + square(factor) * here.squared_altitude;
      edges_[k - 1] = edge;
    }
    ++depth_;
    if (depth_ + 1 == m) prepare_wedge();
    return Verdict::proved;
  }

  void pop() { --depth_; }

  /// Relative to v0. Preconditions of all of these: every push so far was proved.
  [[nodiscard]] const Point& centre() const { return level_[static_cast<std::size_t>(depth_)].centre; }
  [[nodiscard]] const S& squared_radius() const { return level_[static_cast<std::size_t>(depth_)].squared_radius; }
  /// Squared distance of the last vertex from the hull of the others.
  [[nodiscard]] const S& squared_altitude() const { return level_[static_cast<std::size_t>(depth_)].squared_altitude; }
  /// |y − c|² − R² for the point v0 + y: negative inside the diametric sphere.
  [[nodiscard]] S power(const Point& y, const S& squared_norm) const {
    return squared_norm - twice(metric_->inner(y, centre()));
  }

  /// The m-simplex over the current facet with apex v0 + edge, without pushing: its centre is that of the facet plus
  /// `factor` times the facet's normal.
  struct Apex {
    Verdict non_degenerate = Verdict::undecided;  // unless proved, the rest is not set
    S factor{};
    S squared_radius{};
  };
  /// Precondition: dimension() is m − 1.
  [[nodiscard]] Apex apex(const Point& edge, const S& squared_edge) const {
    Apex result;
    S slope = pairing(covector_, edge);  // ⟨normal, edge⟩
    if (!metric_->is_cartesian()) slope *= metric_->determinant();
    result.non_degenerate = negation(is_zero(slope));
    if (!is_proved(result.non_degenerate)) return result;
    result.factor = power(edge, squared_edge) / twice(slope);
    result.squared_radius = squared_radius() + square(result.factor) * squared_normal_;
    return result;
  }
  /// What is needed of a point v0 + y to know its power with respect to the sphere of any apex over this facet.
  struct Probe {
    S power{};   // with respect to the facet's diametric sphere
    S height{};  // ⟨normal, y⟩
  };
  [[nodiscard]] Probe probe(const Point& y, const S& squared_norm) const {
    return {power(y, squared_norm), metric_->inner(normal_, y)};
  }
  [[nodiscard]] static S power_over(const Apex& apex, const Probe& probe) {
    return probe.power - twice(apex.factor * probe.height);
  }
  [[nodiscard]] Point centre_over(const Apex& apex) const { return sum(centre(), scaled(apex.factor, normal_)); }

 private:
  struct Level {
    Point centre;
    Point orthogonal;
    S squared_radius;
    S squared_altitude;
  };

  [[gnu::flatten]] void prepare_wedge() {
    covector_ = wedge(edges_);
    normal_ = metric_->raised(covector_);
    squared_normal_ = metric_->squared_norm(normal_);
  }

  const MetricOn<S, m>* metric_;
  int depth_ = 0;
  std::array<Level, static_cast<std::size_t>(m) + 1> level_;
  std::array<Point, static_cast<std::size_t>(m)> edges_;  // the last entry is never read
  Point covector_;
  Point normal_;
  S squared_normal_;
};

}  // namespace delcert
