#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kernel/chart/atlas.hpp"
#include "kernel/manifold/gluing/affine_chart.hpp"

namespace delcert {

/// What manifolds in affine charts φ_i(x) = A_i(x − p_i) of coordinates have in common: metric fields on a torus, and
/// charts that are glued by formulas. Home coordinates of a label are those of its own chart, p_i itself is 0 there;
/// all patches have the radius fε with one whole number f. Transitions are exact on the last rung.
template <int m>
class AffineAtlas : public Atlas<m> {
 public:
  static constexpr int greatest_patch_factor = 9;
  static constexpr int least_patch_factor = 4;

  /// Gives all patches this factor. Precondition: from 4 to the widest.
  void set_patch_factor(int patch_factor) { patch_factor_ = patch_factor; }
  /// The greatest with which patches fit.
  [[nodiscard]] int widest_patch_factor() const { return widest_patch_factor_; }

  [[nodiscard]] const AffineChart<m>& chart(Label i) const { return charts_[i.value]; }
  /// p_i.
  [[nodiscard]] Vector<Rational, m> centre(Label i) const { return centres_.exact(i); }
  [[nodiscard]] const Rational& sampling_radius() const { return sampling_radius_; }
  [[nodiscard]] int patch_factor() const { return patch_factor_; }
  [[nodiscard]] Rational patch_radius() const { return Rational(patch_factor_) * sampling_radius_; }
  /// What the filter needs of a chart: enclosures.
  struct Enclosed {
    Matrix<Interval, m> matrix;
    Matrix<Interval, m> inverse;
    Matrix<Interval, m> gram;
    Vector<double, m> stretch;  // upper bounds of √(B⁻¹)_kk
  };
  [[nodiscard]] const Enclosed& enclosed(Label i) const { return enclosed_[i.value]; }
  /// An enclosure of B_i = A_iᵀA_i.
  [[nodiscard]] const Matrix<Interval, m>& enclosed_gram(Label i) const { return enclosed_[i.value].gram; }
  /// The point with these home coordinates: p_i + A_i⁻¹y.
  [[nodiscard]] Vector<Rational, m> position(Label i, const Vector<Rational, m>& home) const {
    return sum(centre(i), upper_applied(chart(i).inverse(), home));
  }

  [[nodiscard]] std::size_t size() const override { return centres_.size(); }
  [[nodiscard]] const FrameMetric<m>& metric() const override { return metric_; }
  [[nodiscard]] const Rational& sampling_radius(Label) const override { return sampling_radius_; }
  [[nodiscard]] bool is_interior(Label) const override { return true; }
  /// All 0.
  [[nodiscard]] const PointSet<m>& net() const override { return net_; }
  [[nodiscard]] std::vector<Sighting<m>> neighbours(Label i) const override;
  [[nodiscard]] Vector<Filter, m> carry(Label i, const Sighting<m>& seen, const Vector<Filter, m>& home) const override;
  [[nodiscard]] Vector<BigInterval, m> carry(Label i, const Sighting<m>& seen,
                                             const Vector<BigInterval, m>& home) const override;
  [[nodiscard]] std::optional<Vector<Rational, m>> carry(Label i, const Sighting<m>& seen,
                                                         const Vector<Rational, m>& home) const override;
  [[nodiscard]] bool has_exact_transitions() const override { return true; }

 protected:
  /// Throws InputError for a sampling radius ≤ 0, or no points.
  AffineAtlas(std::vector<Vector<Rational, m>> centres, Rational sampling_radius);

  [[nodiscard]] const PointSet<m>& centres() const { return centres_; }

  /// Makes the charts about all centres: of the inner products that these enclosures have. Precondition: rounding to
  /// nearest.
  void make_charts(const std::function<Matrix<Interval, m>(Label)>& gram_at);
  /// The largest factor f from 9 to 4 with which patches fit: with f·ε·stretch_k in the room that label i has along
  /// axis k. None if there is none; `where` is then the label of the least room. Needs a `RoundingGuard`.
  [[nodiscard]] bool fit_patch_factor(const std::function<double(Label, std::size_t)>& room, Label& where);
  /// Whether A_i·offset may be as short as this. Needs a `RoundingGuard`.
  [[nodiscard]] bool may_be_within(Label i, const Vector<Interval, m>& offset, double squared_distance) const {
    const Vector<Interval, m> seen = upper_applied(enclosed(i).matrix, offset);
    Interval squared = square(seen[0]);
    for (std::size_t axis = 1; axis < m; ++axis) squared += square(seen[axis]);
    return squared.lower() <= squared_distance;
  }

  /// How far from p_i the point of coordinates p_j + moved is seen, in the coordinates of p_i.
  [[nodiscard]] virtual Vector<Filter, m> offset(Label i, const Sighting<m>& seen,
                                                 const Vector<Filter, m>& moved) const = 0;
  [[nodiscard]] virtual Vector<BigInterval, m> offset(Label i, const Sighting<m>& seen,
                                                      const Vector<BigInterval, m>& moved) const = 0;
  [[nodiscard]] virtual Vector<Rational, m> offset(Label i, const Sighting<m>& seen,
                                                   const Vector<Rational, m>& moved) const = 0;

 private:
  FrameMetric<m> metric_ = FrameMetric<m>::cartesian();
  PointSet<m> centres_;
  PointSet<m> net_;
  Rational sampling_radius_;
  int widest_patch_factor_ = greatest_patch_factor;
  int patch_factor_ = greatest_patch_factor;
  std::vector<AffineChart<m>> charts_;
  std::vector<Enclosed> enclosed_;
};

}  // namespace delcert
