#include "proofs/checker/geometry/point_set.hpp"

#include <cmath>

namespace delcert::checker {

std::string to_string(const Vertex& v, int dimension) {
  std::string text = std::to_string(v.label) + " + (";
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    text += (k == 0 ? "" : ", ") + std::to_string(v.lift[k]);
  return text + ")";
}

PointSet::PointSet(const Metric& metric, bool periodic, const std::vector<std::string_view>& coordinates,
                   std::vector<Interval> read)
    : metric_(&metric),
      coordinates_(&coordinates),
      periodic_(periodic),
      dimension_(static_cast<std::size_t>(metric.dimension())),
      filter_(std::move(read)) {
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    const bool is_read = std::isfinite(filter_[k].upper());
    Budget::spend(is_read ? coordinates[k].size() : 0);
    if (!is_read) filter_[k] = enclosure(exact_value(coordinates[k]));
  }
}

std::vector<Lift> PointSet::lifts_within(const Vertex& v, Label label, const Quantity& a, bool closed) const {
  std::vector<Lift> found;
  for_lifts_within(v, label, a, closed, [&](const Lift& lift) { found.push_back(lift); });
  return found;
}

Lift PointSet::lattice_vector_within(const Quantity& a, bool closed) const {
  for (const Lift& lift : lifts_within({0, {}}, 0, a, closed)) {
    if (lift != Lift{}) return lift;
  }
  return {};
}

}  // namespace delcert::checker
