#pragma once

#include <memory>
#include <vector>

#include "kernel/chart/torus_cells.hpp"
#include "kernel/manifold/gluing/affine_atlas.hpp"
#include "kernel/manifold/gluing/gluing_metric.hpp"
#include "kernel/manifold/gluing/piecewise_cells.hpp"

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
    const Shown& shown = shown_[home_[i.value]];
    const double reach = patch_reach();
    const double most = reach * reach;  // rounded upwards
    Vector<double, m> half_widths;
    for (std::size_t axis = 0; axis < m; ++axis)
      half_widths[axis] = reach * this->enclosed(i).stretch[axis] + shown.spread[axis];
    const Vector<Interval, m> here = enclosed_centre(i);
    visit_cells(shown, *shown.by_image, here, half_widths, [&](const Appearance& seen) {
      if (this->may_be_within(i, difference(seen.image, here), most)) visit(Label(seen.label), seen.derivative);
    });
  }

 private:
  /// A label as a chart of the file shows it.
  struct Appearance {
    std::uint32_t label;
    std::uint32_t route;
    bool is_seen;               ///< whether the transition is defined at the point itself
    Vector<Interval, m> place;  ///< then: of the point
    Vector<Interval, m> image;  ///< of all its moved points that the chart shows
    Matrix<Interval, m> derivative;
  };
  struct Shown {
    std::vector<Appearance> appearances;
    Vector<double, m> spread{};  ///< the greatest widths of images
    Vector<double, m> lowest{};  ///< of the box
    Vector<double, m> scale{};   ///< coordinates to the unit cube
    std::unique_ptr<TorusCells<m>> by_place;
    std::unique_ptr<TorusCells<m>> by_image;
  };
  struct Evaluations;
  enum class Following { nowhere, somewhere, uncertain };
  /// What the transition makes of a point and of all points that it may be moved to.
  [[nodiscard]] Following follow(std::size_t transition, const Cell& still, const Cell& moved, PiecewiseCells& on_cells,
                                 Appearance& seen) const;
  static void include_image(const MapOnCell& found, const Interval* derivative, bool is_first, Appearance& seen);

  void require_places(const std::vector<NetPlace<m>>& net) const;
  void choose_patches();
  void find_appearances();
  void note_appearances(Label i, std::vector<PiecewiseCells>& on_cells);
  void fill_cells();
  [[nodiscard]] double patch_reach() const;
  [[nodiscard]] Vector<double, m> in_unit_cube(const Shown& shown, const Vector<Interval, m>& place) const;
  [[nodiscard]] Vector<Interval, m> enclosed_centre(Label i) const {
    const Vector<Filter, m>& centre = this->centres().enclosure(i);
    Vector<Interval, m> result;
    for (std::size_t axis = 0; axis < m; ++axis)
      result[axis] = Interval::between(centre[axis].lower(), centre[axis].upper());
    return result;
  }

  template <class Visit>
  void visit_cells(const Shown& shown, const TorusCells<m>& cells, const Vector<Interval, m>& here,
                   const Vector<double, m>& half_widths, const Visit& visit) const {
    Vector<double, m> widths;
    for (std::size_t axis = 0; axis < m; ++axis) widths[axis] = half_widths[axis] * shown.scale[axis];
    cells.visit(in_unit_cube(shown, here), widths, [&](const Lift<m>& lift) {
      if (lift.is_unmoved()) visit(shown.appearances[lift.index]);
      return false;
    });
  }

  [[noreturn]] void throw_undefined(std::size_t transition) const;
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
