#include "proofs/checker/point_set.hpp"

#include "proofs/checker/report.hpp"

namespace delcert::checker {

std::string to_string(const Vertex& v, int dimension) {
  std::string text = std::to_string(v.label) + " + (";
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    text += (k == 0 ? "" : ", ") + std::to_string(v.lift[k]);
  return text + ")";
}

PointSet::PointSet(const Metric& metric, bool periodic, const std::vector<std::string_view>& coordinates)
    : metric_(&metric),
      coordinates_(&coordinates),
      periodic_(periodic),
      dimension_(static_cast<std::size_t>(metric.dimension())) {
  filter_.reserve(coordinates.size());
  for (const std::string_view text : coordinates) {
    const std::optional<double> x = as_double(text);
    Budget::spend(x ? text.size() : 0);
    filter_.push_back(x ? Interval::between(*x, *x) : enclosure(exact_value(text)));
  }
}

std::vector<Lift> PointSet::lifts_within(const Vertex& v, Label label, const Quantity& a, bool closed) const {
  const Vector<Interval> offset = position<Interval>({label, {}}) - position<Interval>(v);
  std::array<Lift, 2> range{};  // first and last
  double number = 1;
  for (std::size_t k = 0; periodic_ && k < dimension_; ++k) {
    const double reach = a.filter.upper() * metric_->stretch(k);
    const Interval box = Interval::between(-reach, reach) - offset[k];
    const double first = std::ceil(box.lower()), last = std::floor(box.upper());
    if (first > last) return {};
    number *= last - first + 1;
    if (!(number <= 1e7 && first > -0x1p30 && last < 0x1p30)) throw Undecided("too many lifts to look at");
    Budget::spend(static_cast<std::uint64_t>(number));
    range[0][k] = static_cast<std::int32_t>(first);
    range[1][k] = static_cast<std::int32_t>(last);
  }
  std::vector<Lift> found;
  Lift lift;
  for (lift[3] = range[0][3]; lift[3] <= range[1][3]; ++lift[3]) {
    for (lift[2] = range[0][2]; lift[2] <= range[1][2]; ++lift[2]) {
      for (lift[1] = range[0][1]; lift[1] <= range[1][1]; ++lift[1]) {
        for (lift[0] = range[0][0]; lift[0] <= range[1][0]; ++lift[0]) {
          const auto within = [&]<class N>(In<N>) {
            const N squared = between<N>(v, {label, lift}), bound = square(a.as<N>());
            return closed ? less_equal(squared, bound) : less(squared, bound);
          };
          if (decide(within)) found.push_back(lift);
        }
      }
    }
  }
  return found;
}

Lift PointSet::lattice_vector_within(const Quantity& a, bool closed) const {
  for (const Lift& lift : lifts_within({0, {}}, 0, a, closed)) {
    if (lift != Lift{}) return lift;
  }
  return {};
}

}  // namespace delcert::checker
