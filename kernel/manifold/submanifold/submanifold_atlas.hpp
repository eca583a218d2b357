#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "kernel/chart/ambient_grid.hpp"
#include "kernel/chart/chart_view.hpp"
#include "kernel/manifold/submanifold/graph_check.hpp"

namespace delcert {

/// A zero set in ℝᴺ with charts in planes that are nearly tangent (docs/submanifolds.md). Home coordinates y of a label
/// i name the point of M in the cylinder of i over them; y = 0 is p_i. A label is seen in chart i if its original point
/// lies in the cylinder of i, at Eᵀ(p − c): one place, no shifts. Transitions are enclosed, never exact.
template <int m>
class SubmanifoldAtlas final : public Atlas<m> {
 public:
  /// Precondition: the zero set has dimension m, and the charts have passed `fit_charts` with this radius. Throws
  /// Undecided, with the label, if an original point cannot be enclosed. Precondition: rounding to nearest.
  SubmanifoldAtlas(ZeroSet zero_set, FittedCharts charts, Rational sampling_radius, const Progress& progress);

  [[nodiscard]] const ZeroSet& zero_set() const { return zero_set_; }
  [[nodiscard]] const TangentChart& chart(Label i) const { return charts_.charts[i.value]; }
  [[nodiscard]] const std::vector<TangentChart>& charts() const { return charts_.charts; }
  /// L.
  [[nodiscard]] const Rational& slope() const { return charts_.slope; }
  [[nodiscard]] const Rational& sampling_radius() const { return sampling_radius_; }
  [[nodiscard]] int patch_factor() const { return charts_.patch_factor; }
  [[nodiscard]] Rational patch_radius() const { return Rational(charts_.patch_factor) * sampling_radius_; }

  /// The point of M over these home coordinates in the cylinder of i, enclosed, N coordinates; S = Interval (needs a
  /// `RoundingGuard`) or BigInterval. None if it cannot be, at this precision.
  template <class S>
  [[nodiscard]] std::optional<std::vector<S>> position(Label i, const Vector<S, m>& home) const;
  /// Appends the labels whose original points are within the distance of that of i in ℝᴺ, and possibly a few that are
  /// slightly farther, sorted; i is among them.
  void near(Label i, double distance, std::vector<Label>& out) const;

  [[nodiscard]] std::size_t size() const override { return charts_.charts.size(); }
  [[nodiscard]] const FrameMetric<m>& metric() const override { return metric_; }
  [[nodiscard]] const Rational& sampling_radius(Label) const override { return sampling_radius_; }
  [[nodiscard]] bool is_interior(Label) const override { return true; }
  /// All 0.
  [[nodiscard]] const PointSet<m>& net() const override { return net_; }
  [[nodiscard]] std::vector<Sighting<m>> neighbours(Label i) const override;
  /// By the distances in the chart of i. Beyond the patch also what is within the distance in ℝᴺ.
  void sightings(Label i, double distance, std::vector<Sighting<m>>& out) const override;
  [[nodiscard]] Vector<Filter, m> carry(Label i, const Sighting<m>& seen, const Vector<Filter, m>& home) const override;
  [[nodiscard]] Vector<BigInterval, m> carry(Label i, const Sighting<m>& seen,
                                             const Vector<BigInterval, m>& home) const override;
  /// None.
  [[nodiscard]] std::optional<Vector<Rational, m>> carry(Label i, const Sighting<m>& seen,
                                                         const Vector<Rational, m>& home) const override;
  [[nodiscard]] bool has_exact_transitions() const override { return false; }

 private:
  struct Seen {
    std::uint32_t index;
    float distance;  ///< a lower bound of |φ_i(p_j)|
  };
  /// What was last asked of a label. It depends on the label and the coordinates alone, so no thread can tell who
  /// asked.
  struct Remembered {
    Vector<Interval, m> home{};
    std::vector<Interval> position;  ///< empty: nothing yet
  };
  static constexpr std::size_t lock_count = 256;

  void enclose_originals(const Progress& progress);
  void find_patches(const Progress& progress);
  [[nodiscard]] std::vector<Seen> patch_of(Label i, double reach) const;
  /// Writes x[N]; unbounded if it cannot be enclosed.
  void filtered_position(Label i, const Vector<Interval, m>& home, Interval* x) const;

  ZeroSet zero_set_;
  FittedCharts charts_;
  Rational sampling_radius_;
  FrameMetric<m> metric_ = FrameMetric<m>::cartesian();
  PointSet<m> net_;
  std::vector<Interval> originals_;  // p_i, N coordinates each
  AmbientGrid grid_;
  std::vector<std::vector<Seen>> patches_;  // by their labels
  mutable std::vector<Remembered> remembered_;
  std::unique_ptr<std::array<std::mutex, lock_count>> locks_;
};

/// Patches, and how much longer a vector may be there than at home: what certification asks of a submanifold.
template <int m>
[[nodiscard]] ModelGeometry geometry_of(const SubmanifoldAtlas<m>& atlas) {
  ModelGeometry geometry;
  geometry.patch_factor = atlas.patch_factor();
  geometry.distortion = distortion_of_slope(atlas.slope());
  return geometry;
}

}  // namespace delcert
