#pragma once

#include <array>
#include <concepts>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "kernel/chart/ambient_grid.hpp"
#include "kernel/chart/chart_view.hpp"
#include "kernel/manifold/submanifold/chart_fitting.hpp"

namespace delcert {

/// A manifold in ℝᴺ with charts in planes that are nearly tangent (docs/submanifolds.md). Home coordinates y of a label
/// i name the point of M in the cylinder of i over them; y = 0 is p_i. A label is seen in chart i if its original point
/// lies in the cylinder of i, at Eᵀ(p − c): one place, no shifts. Transitions are exact if heights over rational places
/// are.
template <int m>
class SubmanifoldAtlas final : public Atlas<m> {
 public:
  /// Precondition: the manifold has dimension m, and the charts have passed `fit_charts` with these radii. Throws
  /// Undecided, with the label, if an original point cannot be enclosed. Precondition: rounding to nearest.
  SubmanifoldAtlas(std::shared_ptr<const EmbeddedManifold> manifold, FittedCharts charts, SamplingRadii radii,
                   const Progress& progress);

  template <std::derived_from<EmbeddedManifold> M>
  SubmanifoldAtlas(M manifold, FittedCharts charts, SamplingRadii radii, const Progress& progress)
      : SubmanifoldAtlas(std::make_shared<M>(std::move(manifold)), std::move(charts), std::move(radii), progress) {}

  [[nodiscard]] const EmbeddedManifold& manifold() const { return *manifold_; }
  [[nodiscard]] const TangentChart& chart(Label i) const { return charts_.charts[i.value]; }
  [[nodiscard]] const std::vector<TangentChart>& charts() const { return charts_.charts; }
  /// L.
  [[nodiscard]] const Rational& slope() const { return charts_.slope; }
  [[nodiscard]] const SamplingRadii& radii() const { return radii_; }
  /// ε, the greatest of them.
  [[nodiscard]] const Rational& sampling_radius() const { return radii_.greatest(); }
  [[nodiscard]] const Rational& patch_factor() const { return charts_.patch_factor; }
  /// Of a label with the greatest sampling radius.
  [[nodiscard]] Rational patch_radius() const { return charts_.patch_factor * sampling_radius(); }

  /// The point of M over these home coordinates in the cylinder of i, enclosed, N coordinates; S = Interval (needs a
  /// `RoundingGuard`), BigInterval or Rational. None if it cannot be, at this precision; exactly, if it is not
  /// rational.
  template <class S>
  [[nodiscard]] std::optional<std::vector<S>> position(Label i, const Vector<S, m>& home) const;
  /// Appends the labels whose original points are within the distance of that of i in ℝᴺ, and possibly a few that are
  /// slightly farther, sorted; i is among them.
  void near(Label i, double distance, std::vector<Label>& out) const;

  [[nodiscard]] std::size_t size() const override { return charts_.charts.size(); }
  [[nodiscard]] const FrameMetric<m>& metric() const override { return metric_; }
  [[nodiscard]] const Rational& sampling_radius(Label i) const override { return radii_.of(i.value); }
  [[nodiscard]] bool is_interior(Label) const override { return true; }
  /// All 0.
  [[nodiscard]] const PointSet<m>& net() const override { return net_; }
  [[nodiscard]] std::vector<Sighting<m>> neighbours(Label i) const override;
  /// By the distances in the chart of i. Beyond the patch also what is within the distance in ℝᴺ.
  void sightings(Label i, double distance, std::vector<Sighting<m>>& out) const override;
  [[nodiscard]] Vector<Filter, m> carry(Label i, const Sighting<m>& seen, const Vector<Filter, m>& home) const override;
  [[nodiscard]] Vector<BigInterval, m> carry(Label i, const Sighting<m>& seen,
                                             const Vector<BigInterval, m>& home) const override;
  [[nodiscard]] std::optional<Vector<Rational, m>> carry(Label i, const Sighting<m>& seen,
                                                         const Vector<Rational, m>& home) const override;
  [[nodiscard]] bool has_exact_transitions() const override { return !manifold_->is_smooth(); }

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
  [[nodiscard]] std::vector<Seen> patch_of(Label i) const;
  /// Writes x[N]; unbounded if it cannot be enclosed.
  void filtered_position(Label i, const Vector<Interval, m>& home, Interval* x) const;

  std::shared_ptr<const EmbeddedManifold> manifold_;
  FittedCharts charts_;
  SamplingRadii radii_;
  FrameMetric<m> metric_ = FrameMetric<m>::cartesian();
  PointSet<m> net_;
  std::vector<Interval> originals_;  // p_i, N coordinates each
  AmbientGrid grid_;
  std::vector<std::vector<Seen>> patches_;  // by their labels
  mutable std::vector<Remembered> remembered_;
  std::unique_ptr<std::array<std::mutex, lock_count>> locks_;
};

/// ε₀: sampling radii of labels with centres within 6ε_i of that of i differ from ε_i by this at most, as parts of the
/// lesser; with few digits. 0 if all are the same.
[[nodiscard]] Rational radius_variation(const std::vector<TangentChart>& charts, const SamplingRadii& radii);

/// Patches, and how much longer a vector may be there than at home: what certification asks of a submanifold.
template <int m>
[[nodiscard]] ModelGeometry geometry_of(const SubmanifoldAtlas<m>& atlas) {
  ModelGeometry geometry;
  geometry.patch_factor = atlas.patch_factor();
  geometry.distortion = distortion_of_slope(atlas.slope());
  return geometry;
}

}  // namespace delcert
