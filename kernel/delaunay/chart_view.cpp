#include "kernel/delaunay/chart_view.hpp"

#include <algorithm>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

template <int m>
ChartView<m>::ChartView(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry)
    : atlas_(&atlas), points_(&points), geometry_(geometry) {
  const FilterGuard guard;
  const auto metric = atlas.metric().template on<Filter>();
  Filter most(0);
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    const auto offset = difference(points.enclosure(Label(index)), atlas.net().enclosure(Label(index)));
    most = maximum(most, metric.squared_norm(offset));
  }
  displacement_ = (square_root(most) * scalar_from<Filter>(Rational(1) + geometry.distortion)).upper();
}

template <int m>
void ChartView<m>::look(Label chart, double reach) {
  chart_ = chart;
  reach_ = reach;
  conformal_.clear();
  atlas_->sightings(chart, reach, seen_);
  position_.clear();
  const FilterGuard guard;
  const Vector<Filter, m>& centre = atlas_->net().enclosure(chart);
  for (const Sighting<m>& seen : seen_) {
    position_.push_back(difference(atlas_->carry(chart, seen, points_->enclosure(label_of<m>(seen))), centre));
  }
}

template <int m>
void ChartView<m>::look_by_halves(Label chart, int half_radii) {
  // A hair less, as patches may be cut off at exactly their radius.
  look(chart, approximate_double(atlas_->sampling_radius(chart)) * half_radii / 2 * (1 - 0x1p-40));
}

template <int m>
std::vector<int> ChartView<m>::half_reaches(std::initializer_list<int> wanted) const {
  std::vector<int> result;
  for (const int reach : wanted) {
    if (reach < 2 * geometry_.patch_factor) result.push_back(reach);
  }
  result.push_back(2 * geometry_.patch_factor);
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
  const Filter radius = Filter::exactly(reach_) - Filter::exactly(displacement_);
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

#define DELCERT_INSTANTIATE(m) template class ChartView<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
