#include "kernel/chart/box_index.hpp"

#include <algorithm>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

template <int m>
void BoxIndex<m>::fill(const std::vector<Vector<Filter, m>>& points) {
  entries_.clear();
  entries_.reserve(points.size());
  Filter widest(0);
  for (const auto& point : points) {
    Entry entry{{}, {}, static_cast<std::uint32_t>(entries_.size())};
    for (std::size_t axis = 0; axis < m; ++axis) {
      entry.lower[axis] = point[axis].lower();
      entry.upper[axis] = point[axis].upper();
    }
    widest = maximum(widest, point[0] - point[0]);
    entries_.push_back(entry);
  }
  widest_ = widest.upper();
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.lower[0] < b.lower[0] || (a.lower[0] == b.lower[0] && a.point < b.point);
  });
}

template <int m>
void BoxIndex<m>::meeting(const Vector<double, m>& lowest, const Vector<double, m>& highest,
                          std::vector<std::uint32_t>& out) const {
  out.clear();
  const double first = (Filter::between(lowest[0], lowest[0]) - Filter::between(widest_, widest_)).lower();
  auto entry = std::lower_bound(entries_.begin(), entries_.end(), first,
                                [](const Entry& one, double bound) { return one.lower[0] < bound; });
  // Every point is written, and kept if it meets the box: whether it does cannot be foreseen, so nothing branches on
  // it.
  out.resize(entries_.size());
  std::size_t count = 0;
  for (; entry != entries_.end() && !(entry->lower[0] > highest[0]); ++entry) {
    unsigned misses = entry->upper[0] < lowest[0] ? 1 : 0;
    for (std::size_t axis = 1; axis < m; ++axis) {
      misses |= entry->lower[axis] > highest[axis] ? 1U : 0U;
      misses |= entry->upper[axis] < lowest[axis] ? 1U : 0U;
    }
    out[count] = entry->point;
    count += 1 - misses;
  }
  out.resize(count);
}

#define DELCERT_INSTANTIATE(m) template class BoxIndex<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
