#include "kernel/chart/chart_view.hpp"

#include <algorithm>

#include "kernel/chart/length_units.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

template <int m>
ChartView<m>::ChartView(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry)
    : atlas_(&atlas), points_(&points), geometry_(geometry), filter_metric_([&] {
        const FilterGuard guard;
        return atlas.metric().template on<Filter>();
      }()) {
  std::vector<double> own;
  {
    const FilterGuard guard;
    Filter most(0);
    const Filter stretch = scalar_from<Filter>(Rational(1) + geometry.distortion);
    for (std::uint32_t index = 0; index < points.size(); ++index) {
      const auto offset = difference(points.enclosure(Label(index)), atlas.net().enclosure(Label(index)));
      const Filter squared = filter_metric_.squared_norm(offset);
      own.push_back((square_root(squared) * stretch).upper());
      most = maximum(most, squared);
    }
    displacement_ = std::max((square_root(most) * stretch).upper(), geometry.displacement_of_the_whole);
  }
  if (LengthUnits(atlas).vary()) find_near_displacements(own);
}

/// A point in the patch has its original within its own displacement and √(1 + L²) radii of the patch.
template <int m>
void ChartView<m>::find_near_displacements(const std::vector<double>& own) {
  const double stretch = approximate_double(Rational(1) + geometry_.distortion) * (1 + 0x1p-20);
  auto near = std::make_shared<std::vector<double>>();
  std::vector<Sighting<m>> seen;
  for (std::uint32_t index = 0; index < own.size(); ++index) {
    const double patch = approximate_double(atlas_->sampling_radius(Label(index))) * halves_of_patch() / 2;
    atlas_->sightings(Label(index), stretch * (patch + displacement_), seen);
    double most = own[index];
    for (const Sighting<m>& other : seen) most = std::max(most, own[other.index]);
    near->push_back(most);
  }
  near_displacement_ = std::move(near);
}

template <int m>
void ChartView<m>::look(Label chart, double reach) {
  chart_ = chart;
  reach_ = reach;
  conformal_.clear();
  boxes_.are_filled = false;
  conformal_boxes_.are_filled = false;
  atlas_->sightings(chart, reach, seen_);
  position_.clear();
  const FilterGuard guard;
  const Vector<Filter, m>& centre = atlas_->net().enclosure(chart);
  for (const Sighting<m>& seen : seen_) {
    position_.push_back(difference(atlas_->carry(chart, seen, points_->enclosure(label_of<m>(seen))), centre));
  }
}

template <int m>
double ChartView<m>::reach_of(Label chart, double half_radii) const {
  // A hair less, as patches may be cut off at exactly their radius.
  return approximate_double(atlas_->sampling_radius(chart)) * half_radii / 2 * (1 - 0x1p-40);
}

template <int m>
void ChartView<m>::look_by_halves(Label chart, double half_radii) {
  look(chart, reach_of(chart, half_radii));
}

template <int m>
double ChartView<m>::complete_radius_of_patch(Label chart) const {
  const double reach = reach_of(chart, halves_of_patch());
  const FilterGuard guard;
  const double result = (Filter::exactly(reach) - Filter::exactly(displacement(chart))).lower();
  return result > 0 ? result : 0;
}

template <int m>
std::vector<double> ChartView<m>::half_reaches(std::initializer_list<int> wanted) const {
  const double patch = halves_of_patch();
  std::vector<double> result;
  for (const int reach : wanted) {
    if (reach < patch) result.push_back(reach);
  }
  result.push_back(patch);
  return result;
}

template <int m>
std::optional<std::uint32_t> ChartView<m>::find(Label label) const {
  const auto before = [](const Sighting<m>& seen, Label other) { return label_of<m>(seen) < other; };
  const auto found = std::lower_bound(seen_.begin(), seen_.end(), label, before);
  if (found == seen_.end() || label_of<m>(*found) != label) return std::nullopt;
  if (found + 1 != seen_.end() && label_of<m>(*(found + 1)) == label) return std::nullopt;
  return static_cast<std::uint32_t>(found - seen_.begin());
}

template <int m>
double ChartView<m>::complete_radius(LocalCoordinates coordinates) const {
  const FilterGuard guard;
  const Filter radius = Filter::exactly(reach_) - Filter::exactly(displacement(chart_));
  if (!is_proved(less(Filter(0), radius))) return 0;
  const Filter length = Filter::exactly(radius.lower());
  if (coordinates == LocalCoordinates::chart || geometry_.curvature == Curvature::zero) return length.lower();
  // A ball about the centre has the same centre in conformal coordinates; beyond a right angle nothing is claimed.
  if (geometry_.curvature == Curvature::positive && !is_proved(less(twice(length), straight_angle<Filter>()))) return 0;
  Vector<Filter, m> along{};
  along[0] = length;
  return conformal_coordinates<Filter, m>(exponential<Filter, m>(geometry_.curvature, along))[0].lower();
}

template <int m>
const std::vector<Vector<Filter, m>>& ChartView<m>::conformal_positions() const {
  if (geometry_.curvature == Curvature::zero) return position_;
  if (conformal_.empty()) {
    conformal_.reserve(position_.size());
    for (const auto& v : position_) {
      conformal_.push_back(conformal_coordinates<Filter, m>(exponential<Filter, m>(geometry_.curvature, v)));
    }
  }
  return conformal_;
}

template <int m>
void ChartView<m>::meeting(LocalCoordinates coordinates, const Vector<double, m>& lowest,
                           const Vector<double, m>& highest, std::vector<std::uint32_t>& out) const {
  const bool is_chart = coordinates == LocalCoordinates::chart;
  Boxes& boxes = is_chart ? boxes_ : conformal_boxes_;
  if (!boxes.are_filled) boxes.index.fill(is_chart ? position_ : conformal_positions());
  boxes.are_filled = true;
  boxes.index.meeting(lowest, highest, out);
}

#define DELCERT_INSTANTIATE(m) template class ChartView<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
