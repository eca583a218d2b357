#include "proofs/checker/point_set.hpp"

namespace delcert::checker {

PointSet::PointSet(const Metric& metric, bool periodic, const std::vector<std::string_view>& coordinates)
    : metric_(&metric),
      coordinates_(&coordinates),
      periodic_(periodic),
      dimension_(static_cast<std::size_t>(metric.dimension())) {
  filter_.reserve(coordinates.size());
  for (const std::string_view text : coordinates) filter_.push_back(enclosure(text));
}

std::vector<Lift> PointSet::lifts_within(const Vertex& v, Label label, const Quantity& a, bool closed) const {
  const Vector<Interval> offset = position<Interval>({label, {}}) - position<Interval>(v);
  std::array<double, 4> first{}, last{};
  for (std::size_t k = 0; periodic_ && k < dimension_; ++k) {
    const double reach = a.filter.upper() * metric_->stretch(k);
    const Interval box = Interval::between(-reach, reach) - offset[k];
    first[k] = std::ceil(box.lower());
    last[k] = std::floor(box.upper());
  }
  std::vector<Lift> found;
  for_each_integer_vector(dimension(), first, last, [&](const Lift& lift) {
    const auto within = [&]<class N>(In<N>) {
      const N length = metric_->squared_length(position<N>({label, lift}) - position<N>(v));
      const N bound = square(a.as<N>());
      return closed ? less_equal(length, bound) : less(length, bound);
    };
    if (decide(within)) found.push_back(lift);
    return false;
  });
  return found;
}

}  // namespace delcert::checker
