#pragma once

#include <memory>
#include <vector>

#include "kernel/chart/torus_cells.hpp"
#include "kernel/manifold/gluing/affine_atlas.hpp"
#include "kernel/manifold/gluing/gluing_metric.hpp"

namespace delcert {

/// A point of a net: in a chart, exactly.
template <int m>
struct NetPlace {
  std::size_t chart = 0;
  Vector<Rational, m> x{};
  friend bool operator==(const NetPlace& a, const NetPlace& b) = default;
};

/// Glued charts with the affine charts φ_i(x) = A_i(x − p_i) about the points of a net, p_i in the chart a(i) of the
/// file (docs/atlases.md). A route's `element` is 0 where a label is seen from the same chart of the file; otherwise
/// one more than the number of the transition from the label's chart.
template <int m>
class FormulaAtlas final : public AffineAtlas<m> {
 public:
  /// Of how many sampling radii about p_i transitions are looked at: points do not move farther.
  static Rational greatest_displacement() { return Rational(Integer(1), Integer(4)); }

  /// Patches have the radius fε with the largest whole f from 4 to 9 for which the box about each is in the open box of
  /// its chart. Throws InputError for a sampling radius ≤ 0, no points, or, naming the label, for one outside of its
  /// chart; Rejection, with a label, if patches do not fit; Undecided if it is not certain whether a transition is
  /// defined near a label. Precondition: `check_gluing` has accepted the charts; rounding to nearest.
  FormulaAtlas(std::shared_ptr<const ChartGluing> gluing, const std::vector<NetPlace<m>>& net,
               Rational sampling_radius);
  ~FormulaAtlas() override;
  FormulaAtlas(FormulaAtlas&&) noexcept;

  [[nodiscard]] const ChartGluing& gluing() const { return *gluing_; }
  /// a(i).
  [[nodiscard]] std::size_t home_chart(Label i) const { return home_[i.value]; }

  /// By the distances in the chart of i. Precondition: at most the radius of a patch.
  void sightings(Label i, double distance, std::vector<Sighting<m>>& out) const override;

  /// Calls visit(label, D) for all labels some point of which, within `greatest_displacement` of it, the patch of i may
  /// show: D encloses the derivative of the transition at all these points. Needs a `RoundingGuard`.
  template <class Visit>
  void visit_derivatives(Label i, const Visit& visit) const {
    visit_seen(i, scaled(patch_reach(), this->enclosed(i).stretch), true,
               [&](const Appearance& seen, const Vector<Interval, m>& offset) {
                 Vector<Interval, m> moved;
                 for (std::size_t axis = 0; axis < m; ++axis)
                   moved[axis] = offset[axis] + Interval::between(-seen.spread[axis], seen.spread[axis]);
                 if (!this->may_be_within(i, moved, patch_reach() * patch_reach())) return;
                 visit(Label(seen.label), seen.derivative);
               });
  }

 private:
  /// A label as a chart of the file shows it.
  struct Appearance {
    std::uint32_t label;
    std::uint32_t route;
    Vector<Interval, m> place;
    Vector<double, m> spread;  ///< how far its moved points are from it there at most
    Matrix<Interval, m> derivative;
  };
  struct Shown {
    std::vector<Appearance> appearances;
    Vector<double, m> spread{};  ///< the greatest
    Vector<double, m> lowest{};  ///< of the box
    Vector<double, m> scale{};   ///< coordinates to the unit cube
    std::unique_ptr<TorusCells<m>> cells;
  };
  struct Evaluations;
  /// What the transition makes of a point and of all points that it may be moved to; false if that is not certain.
  [[nodiscard]] bool follow(std::size_t transition, const Cell& still, const Cell& moved, Appearance& seen) const;

  void require_places(const std::vector<NetPlace<m>>& net) const;
  void choose_patches();
  void find_appearances();
  void note_appearances(Label i, std::vector<CellMapEvaluation>& on_cells);
  void fill_cells();
  [[nodiscard]] double patch_reach() const;
  [[nodiscard]] Vector<double, m> in_unit_cube(const Shown& shown, const Vector<Interval, m>& place) const;

  template <class Visit>
  void visit_seen(Label i, const Vector<double, m>& half_widths, bool with_spread, const Visit& visit) const {
    const Shown& shown = shown_[home_[i.value]];
    const Vector<Filter, m>& centre = this->centres().enclosure(i);
    Vector<double, m> widths;
    Vector<Interval, m> here;
    for (std::size_t axis = 0; axis < m; ++axis) {
      here[axis] = Interval::between(centre[axis].lower(), centre[axis].upper());
      widths[axis] = (half_widths[axis] + (with_spread ? shown.spread[axis] : 0)) * shown.scale[axis];
    }
    shown.cells->visit(in_unit_cube(shown, here), widths, [&](const Lift<m>& lift) {
      if (!lift.is_unmoved()) return false;
      const Appearance& seen = shown.appearances[lift.index];
      visit(seen, difference(seen.place, here));
      return false;
    });
  }

  template <class S>
  [[nodiscard]] Vector<S, m> offset_on(Label i, const Sighting<m>& seen, const Vector<S, m>& moved) const;
  [[nodiscard]] Vector<Filter, m> offset(Label i, const Sighting<m>& seen,
                                         const Vector<Filter, m>& moved) const override;
  [[nodiscard]] Vector<BigInterval, m> offset(Label i, const Sighting<m>& seen,
                                              const Vector<BigInterval, m>& moved) const override;
  [[nodiscard]] Vector<Rational, m> offset(Label i, const Sighting<m>& seen,
                                           const Vector<Rational, m>& moved) const override;

  std::shared_ptr<const ChartGluing> gluing_;
  std::vector<std::size_t> home_;
  std::vector<Shown> shown_;
  std::unique_ptr<Evaluations> evaluations_;
};

}  // namespace delcert
