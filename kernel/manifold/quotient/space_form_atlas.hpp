#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "kernel/chart/atlas.hpp"
#include "kernel/chart/lift_grid.hpp"
#include "kernel/chart/near_lists.hpp"
#include "kernel/manifold/quotient/frame.hpp"
#include "kernel/manifold/quotient/group_lifts.hpp"

namespace delcert {

/// A space form X/Γ with the charts φ_i = exp_o⁻¹ ∘ F_i⁻¹ about the points of a net, each point with one lift p̂_i,
/// which its exact conformal coordinates give (for curvature 0: coordinates of the frame of the Gram matrix). Home
/// coordinates of a label are tangent vectors at p̂_i; p_i itself is 0 there.
///
/// The element of a sighting is the position of a group element γ in `elements`; the label j is seen at γp̂_j. So k seen
/// from j through γ′, where i sees j through γ, is seen from i through γγ′.
///
/// Enclosures on the filter are some 10⁻¹⁵ wide in absolute terms (docs/space-forms.md has a table): for curvature 0
/// and 1 entries of matrices are at most 1, or small integers; for curvature −1 widths grow with cosh² of the distances
/// of both points from o, whatever γ is.
template <int m>
class SpaceFormAtlas final : public Atlas<m> {
 public:
  /// The radius of U_i over ε in the paper.
  static constexpr int patch_factor = 9;

  /// U_i = B(p_i, factor·ε). Throws Rejection, with the values, unless (factor + 3)·ε ≤ inj(M) and, on a sphere,
  /// factor·ε < π/2: then every label is seen at one lift at most within 3ε more than the radius of a patch, the same
  /// from all charts that are compared. Throws InputError for a sampling radius ≤ 0 and, naming the label, for a point
  /// that has no lift there (|a| ≥ 2 for negative curvature).
  SpaceFormAtlas(SpaceForm form, std::vector<Vector<Rational, m>> centres, Rational sampling_radius,
                 int factor = patch_factor);

  [[nodiscard]] const SpaceForm& form() const { return form_; }
  [[nodiscard]] Curvature curvature() const { return form_.form().curvature(); }
  [[nodiscard]] const Rational& sampling_radius() const { return sampling_radius_; }
  /// Of every U_i.
  [[nodiscard]] const Rational& patch_radius() const { return patch_radius_; }
  /// The conformal coordinates of p̂_i.
  [[nodiscard]] Vector<Rational, m> centre(Label i) const { return centres_.exact(i); }
  /// The group elements that sightings name, the identity first.
  [[nodiscard]] const std::vector<FieldMatrix>& elements() const { return lifts_.table().elements(); }
  /// The number of this element; throws std::out_of_range if no sighting names it.
  [[nodiscard]] std::uint32_t number_of(const FieldMatrix& element) const { return lifts_.table().number_of(element); }
  /// The number of γ_a γ_b, and of γ_a⁻¹; throw std::out_of_range if no sighting names it.
  [[nodiscard]] std::uint32_t product(std::uint32_t a, std::uint32_t b) const { return lifts_.table().product(a, b); }
  [[nodiscard]] std::uint32_t inverse(std::uint32_t a) const { return lifts_.table().inverse(a); }

  /// γ·F_j·exp_o(home) in the linear model, in the standard basis, for the sighted label j: its lift in X.
  /// S = Filter (needs a `FilterGuard`) or BigInterval.
  template <class S>
  [[nodiscard]] ModelPoint<S, m> lift(const Sighting<m>& seen, const Vector<S, m>& home) const;
  /// exp_o⁻¹ F_i⁻¹ x: a point of X in the chart of i.
  template <class S>
  [[nodiscard]] Vector<S, m> in_chart(Label i, const ModelPoint<S, m>& x) const;
  /// Replaces `out` by the sightings γp̂_j within `distance` of the point x of X, sorted, and possibly a few that are
  /// slightly farther. Precondition: some p̂_i is within patch_radius() − distance of x; a `FilterGuard` is alive.
  void sightings_near(const ModelPoint<Filter, m>& x, double distance, std::vector<Sighting<m>>& out) const;

  [[nodiscard]] std::size_t size() const override { return centres_.size(); }
  [[nodiscard]] const FrameMetric<m>& metric() const override { return metric_; }
  [[nodiscard]] const Rational& sampling_radius(Label) const override { return sampling_radius_; }
  [[nodiscard]] bool is_interior(Label) const override { return true; }
  /// All 0.
  [[nodiscard]] const PointSet<m>& net() const override { return net_; }
  [[nodiscard]] std::vector<Sighting<m>> neighbours(Label i) const override;
  /// Throws std::out_of_range if the distance is more than the radius of the patch.
  void sightings(Label i, double distance, std::vector<Sighting<m>>& out) const override;
  [[nodiscard]] Vector<Filter, m> carry(Label i, const Sighting<m>& seen, const Vector<Filter, m>& home) const override;
  [[nodiscard]] Vector<BigInterval, m> carry(Label i, const Sighting<m>& seen,
                                             const Vector<BigInterval, m>& home) const override;
  [[nodiscard]] std::optional<Vector<Rational, m>> carry(Label i, const Sighting<m>& seen,
                                                         const Vector<Rational, m>& home) const override;
  /// For curvature 0.
  [[nodiscard]] bool has_exact_transitions() const override { return curvature() == Curvature::zero; }

 private:
  struct Moved;
  /// The point with these home coordinates, in the linear model.
  [[nodiscard]] const Moved& moved(std::uint32_t label, const Vector<Interval, m>& home) const;
  using NearNumbers = std::vector<std::uint32_t>;  // of lifts in the grid
  /// Of the lifts within `listed_distance_` of p̂_i; none if there are too many.
  [[nodiscard]] const NearNumbers* listed_about(Label i) const;
  void fill_grid();
  [[nodiscard]] double greatest_distance() const;
  void find_near(const ModelPoint<Interval, m>& x, double distance, std::vector<Sighting<m>>& out) const;
  [[nodiscard]] const ModelMatrix<Interval, m>* lift_frame(std::uint32_t label, std::uint32_t number) const;
  [[nodiscard]] ModelPoint<Interval, m> enclosed_lift(const Sighting<m>& seen, const Vector<Interval, m>& home) const;
  [[nodiscard]] Vector<Interval, m> enclosed_in_chart(Label i, const ModelPoint<Interval, m>& x) const;
  [[nodiscard]] Vector<Rational, m> exactly_carried(Label i, const Sighting<m>& seen,
                                                    const Vector<Rational, m>& home) const;

  SpaceForm form_;
  FrameMetric<m> metric_;
  PointSet<m> centres_;
  Rational sampling_radius_;
  Rational patch_radius_;
  std::vector<Frame<Interval, m>> frames_;
  GroupLifts<m> lifts_;
  LiftGrid<m> grid_;
  PointSet<m> net_;
  // For curvature −1, where a product of enclosures would be wide: γF_j for the lifts in the grid but those by the
  // identity, label by label.
  struct LiftFrame {
    std::uint32_t number;
    ModelMatrix<Interval, m> matrix;
  };
  std::uint64_t number_;  // of this atlas
  typename LiftGrid<m>::Distance listed_distance_;
  std::unique_ptr<NearLists<NearNumbers>> near_;  // the lifts within that distance
  std::vector<std::size_t> first_lift_frame_;
  std::vector<LiftFrame> lift_frames_;
};

}  // namespace delcert
