#pragma once

#include <vector>

#include "kernel/chart/torus_cells.hpp"
#include "kernel/manifold/gluing/affine_atlas.hpp"

namespace delcert {

/// A metric field on ℝᵐ/ℤᵐ with the affine charts φ_i(x) = A_i(x − p_i) about the points of a net, A_iᵀA_i ≈ G(p_i)
/// (docs/metric-fields.md).
///
/// The shift s of a sighting is a lattice vector: the label j is seen at p_j + s.
template <int m>
class MetricFieldAtlas final : public AffineAtlas<m> {
 public:
  /// `centres`: coordinates in [0, 1). Patches have the radius fε with the largest whole f from 4 to 9 such that
  /// 3fε·√(B_i⁻¹)_kk < 1 for every label and axis; throws Rejection, with a label, if there is none, and InputError for
  /// a sampling radius ≤ 0, no points, or, naming the label, for a coordinate outside of [0, 1).
  /// Precondition: rounding to nearest.
  MetricFieldAtlas(MetricField<m> field, std::vector<Vector<Rational, m>> centres, Rational sampling_radius);

  [[nodiscard]] const MetricField<m>& field() const { return field_; }

  /// By the distances in the chart of i. For any distance, also beyond the patch.
  void sightings(Label i, double distance, std::vector<Sighting<m>>& out) const override;

 private:
  void require_points() const;
  void choose_patches();
  void fill_cells();
  template <class S>
  [[nodiscard]] Vector<S, m> offset_on(Label i, const Sighting<m>& seen, const Vector<S, m>& moved) const;
  [[nodiscard]] Vector<Filter, m> offset(Label i, const Sighting<m>& seen,
                                         const Vector<Filter, m>& moved) const override;
  [[nodiscard]] Vector<BigInterval, m> offset(Label i, const Sighting<m>& seen,
                                              const Vector<BigInterval, m>& moved) const override;
  [[nodiscard]] Vector<Rational, m> offset(Label i, const Sighting<m>& seen,
                                           const Vector<Rational, m>& moved) const override;

  MetricField<m> field_;
  TorusCells<m> cells_;
};

}  // namespace delcert
