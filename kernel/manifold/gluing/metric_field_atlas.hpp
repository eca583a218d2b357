#pragma once

#include <optional>
#include <vector>

#include "kernel/chart/atlas.hpp"
#include "kernel/chart/torus_cells.hpp"
#include "kernel/manifold/gluing/affine_chart.hpp"

namespace delcert {

/// A metric field on ℝᵐ/ℤᵐ with the affine charts φ_i(x) = A_i(x − p_i) about the points of a net, A_iᵀA_i ≈ G(p_i)
/// (docs/metric-fields.md). Home coordinates of a label are those of its own chart: p_i itself is 0 there. Transitions
/// are exact on the last rung.
///
/// The shift s of a sighting is a lattice vector: the label j is seen at p_j + s.
template <int m>
class MetricFieldAtlas final : public Atlas<m> {
 public:
  static constexpr int greatest_patch_factor = 9;
  static constexpr int least_patch_factor = 4;

  /// `centres`: coordinates in [0, 1). Patches have the radius fε with the largest whole f from 4 to 9 such that
  /// 3fε·√(B_i⁻¹)_kk < 1 for every label and axis; throws Rejection, with a label, if there is none, and InputError for
  /// a sampling radius ≤ 0, no points, or, naming the label, for a coordinate outside of [0, 1).
  /// Precondition: rounding to nearest.
  MetricFieldAtlas(MetricField<m> field, std::vector<Vector<Rational, m>> centres, Rational sampling_radius);

  /// Makes all patches smaller: of this factor. Precondition: from 4 to what it is.
  void shrink_patches(int patch_factor) { patch_factor_ = patch_factor; }

  [[nodiscard]] const MetricField<m>& field() const { return field_; }
  [[nodiscard]] const AffineChart<m>& chart(Label i) const { return charts_[i.value]; }
  /// p_i.
  [[nodiscard]] const Vector<Rational, m>& centre(Label i) const { return centres_.exact(i); }
  [[nodiscard]] const Rational& sampling_radius() const { return sampling_radius_; }
  [[nodiscard]] int patch_factor() const { return patch_factor_; }
  [[nodiscard]] Rational patch_radius() const { return Rational(patch_factor_) * sampling_radius_; }
  /// An enclosure of B_i = A_iᵀA_i.
  [[nodiscard]] const Matrix<Interval, m>& enclosed_gram(Label i) const { return enclosed_[i.value].gram; }
  /// The point with these home coordinates, in ℝᵐ: p_i + A_i⁻¹y.
  [[nodiscard]] Vector<Rational, m> position(Label i, const Vector<Rational, m>& home) const {
    return sum(centre(i), applied_triangle(chart(i).inverse(), home));
  }

  [[nodiscard]] std::size_t size() const override { return charts_.size(); }
  [[nodiscard]] const FrameMetric<m>& metric() const override { return metric_; }
  [[nodiscard]] const Rational& sampling_radius(Label) const override { return sampling_radius_; }
  [[nodiscard]] bool is_interior(Label) const override { return true; }
  /// All 0.
  [[nodiscard]] const PointSet<m>& net() const override { return net_; }
  [[nodiscard]] std::vector<Sighting<m>> neighbours(Label i) const override;
  /// By the distances in the chart of i. For any distance, also beyond the patch.
  void sightings(Label i, double distance, std::vector<Sighting<m>>& out) const override;
  [[nodiscard]] Vector<Filter, m> carry(Label i, const Sighting<m>& seen, const Vector<Filter, m>& home) const override;
  [[nodiscard]] Vector<BigInterval, m> carry(Label i, const Sighting<m>& seen,
                                             const Vector<BigInterval, m>& home) const override;
  [[nodiscard]] std::optional<Vector<Rational, m>> carry(Label i, const Sighting<m>& seen,
                                                         const Vector<Rational, m>& home) const override;
  [[nodiscard]] bool has_exact_transitions() const override { return true; }

 private:
  /// What the filter needs of a chart.
  struct Enclosed {
    Matrix<Interval, m> matrix;
    Matrix<Interval, m> inverse;
    Matrix<Interval, m> gram;
    Vector<double, m> stretch;  // upper bounds of √(B⁻¹)_kk
  };
  void require_points() const;
  void make_charts();
  void choose_patches();
  void fill_cells();
  template <class S>
  [[nodiscard]] Vector<S, m> carried(Label i, const Sighting<m>& seen, const Vector<S, m>& home,
                                     const Matrix<S, m>& matrix, const Matrix<S, m>& inverse) const;

  MetricField<m> field_;
  FrameMetric<m> metric_ = FrameMetric<m>::cartesian();
  PointSet<m> centres_;
  PointSet<m> net_;
  Rational sampling_radius_;
  int patch_factor_ = greatest_patch_factor;
  std::vector<AffineChart<m>> charts_;
  std::vector<Enclosed> enclosed_;
  TorusCells<m> cells_;
};

}  // namespace delcert
