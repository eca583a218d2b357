#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <vector>

#include "kernel/chart/atlas.hpp"
#include "kernel/chart/box_index.hpp"
#include "kernel/chart/model_space.hpp"

namespace delcert {

/// What certification asks of a space form X/Γ besides its charts; or of a manifold with affine charts, where only the
/// last two count.
struct ModelGeometry {
  Curvature curvature = Curvature::zero;
  Rational injectivity_radius;    ///< a lower bound
  Rational patch_factor = 9;      ///< patches have this radius, in sampling radii: a multiple of 1/4
  bool isometric_charts = false;  ///< transitions are isometries of the charts' metric, as on flat manifolds
  /// How much longer than at home a vector is in another chart at most, relative: 0 on space forms, whose charts keep
  /// the distances from their centres. What a label moves by at home is seen from elsewhere longer by that.
  Rational distortion{};
  /// Where the points at hand are a part of those of a whole: how far one of these is from its original, not below any
  /// of them.
  double displacement_of_the_whole = 0;
};

/// In which coordinates of X about the centre of a chart: tangent vectors, that is those of the chart (exp⁻¹), or
/// conformal ones, in which the balls of X are balls (docs/levels/space-forms.md). For curvature 0 both are the same.
enum class LocalCoordinates { chart, conformal };

/// The points of a set that one chart shows within a reach, all lifts of them, in coordinates about its centre.
template <int m>
class ChartView {
 public:
  /// References are kept. Computes how far points are from their originals at most. Where sampling radii vary,
  /// `Atlas::sightings` has to show what is beyond the patches too.
  ChartView(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry);

  /// Shows the chart of this label: every perturbed point whose original is within `reach` of p_i, in the order of
  /// sightings. Precondition: as for `Atlas::sightings`.
  void look(Label chart, double reach);
  /// The same for a reach of so many halves of a sampling radius.
  void look_by_halves(Label chart, double half_radii);
  /// Reaches, in halves of a sampling radius, to try one after the other: those of these that a patch has, increasing,
  /// and the patch itself at last; never none.
  [[nodiscard]] std::vector<double> half_reaches(std::initializer_list<int> wanted = {7, 10, 14}) const;

  [[nodiscard]] const Atlas<m>& atlas() const { return *atlas_; }
  [[nodiscard]] const PointSet<m>& points() const { return *points_; }
  [[nodiscard]] const ModelGeometry& geometry() const { return geometry_; }
  /// That of the atlas, on the filter. Precondition of its use: a `FilterGuard` is alive.
  [[nodiscard]] const MetricOn<Filter, m>& filter_metric() const { return filter_metric_; }
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] Label chart() const { return chart_; }
  [[nodiscard]] std::size_t size() const { return seen_.size(); }
  [[nodiscard]] const Sighting<m>& sighting(std::size_t at) const { return seen_[at]; }
  [[nodiscard]] Label label(std::size_t at) const { return label_of<m>(seen_[at]); }
  /// The one place at which this label is seen; none if there is no such place, or several.
  [[nodiscard]] std::optional<std::uint32_t> find(Label label) const;

  /// Every lift closer than this to the centre is in the view, in these coordinates. 0 if nothing is known.
  [[nodiscard]] double complete_radius(LocalCoordinates coordinates) const;
  /// The same in the chart of this label, were all of its patch in the view.
  [[nodiscard]] double complete_radius_of_patch(Label chart) const;
  /// No point that the chart of this label may show is farther than this from its original, in a chart.
  [[nodiscard]] double displacement(Label chart) const {
    return near_displacement_ ? (*near_displacement_)[chart.value] : displacement_;
  }

  /// Precondition of this and the next: for S = Filter a `FilterGuard` is alive.
  [[nodiscard]] const Vector<Filter, m>& position(LocalCoordinates coordinates, std::size_t at) const {
    return coordinates == LocalCoordinates::chart ? position_[at] : conformal_positions()[at];
  }
  /// Replaces `out` by the places of all points whose enclosures meet this box, in these coordinates.
  /// Precondition: a `FilterGuard` is alive.
  void meeting(LocalCoordinates coordinates, const Vector<double, m>& lowest, const Vector<double, m>& highest,
               std::vector<std::uint32_t>& out) const;
  template <class S>
  [[nodiscard]] Vector<S, m> position_in(LocalCoordinates coordinates, std::size_t at) const {
    const auto carried = atlas_->carry(chart_, seen_[at], points_->template coordinates<S>(label_of<m>(seen_[at])));
    const auto& centre = atlas_->net().template coordinates<S>(chart_);
    if constexpr (std::same_as<S, Rational>) {
      return difference(carried.value(), centre);  // asked for where transitions are exact only: curvature 0
    } else {
      const Vector<S, m> v = difference(carried, centre);
      if (coordinates == LocalCoordinates::chart || geometry_.curvature == Curvature::zero) return v;
      return conformal_coordinates<S, m>(exponential<S, m>(geometry_.curvature, v));
    }
  }

 private:
  const std::vector<Vector<Filter, m>>& conformal_positions() const;
  void find_near_displacements(const std::vector<double>& own);
  [[nodiscard]] double reach_of(Label chart, double half_radii) const;
  [[nodiscard]] double halves_of_patch() const { return 2 * approximate_double(geometry_.patch_factor); }

  const Atlas<m>* atlas_;
  const PointSet<m>* points_;
  ModelGeometry geometry_;
  MetricOn<Filter, m> filter_metric_;
  double displacement_ = 0;  // of all
  /// By label, where sampling radii vary: of those that its chart may show.
  std::shared_ptr<const std::vector<double>> near_displacement_;
  Label chart_{0};
  double reach_ = 0;
  std::vector<Sighting<m>> seen_;
  std::vector<Vector<Filter, m>> position_;
  mutable std::vector<Vector<Filter, m>> conformal_;  // empty until asked for
  struct Boxes {
    bool are_filled = false;
    BoxIndex<m> index;
  };
  mutable Boxes boxes_;
  mutable Boxes conformal_boxes_;
};

}  // namespace delcert
