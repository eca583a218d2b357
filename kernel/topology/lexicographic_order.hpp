#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace delcert {

/// 0 … count−1 in the lexicographic order of key(entry, 0) … key(entry, length−1), which are below `range`; entries
/// with the same key keep their order. Linear time for each place: stable counting sorts, by the last place first.
template <class Key>
[[nodiscard]] std::vector<std::size_t> lexicographic_order(std::size_t count, std::size_t length, std::size_t range,
                                                           const Key& key) {
  std::vector<std::size_t> order(count), sorted(count), begin(range + 1);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t place = length; place-- > 0;) {
    std::fill(begin.begin(), begin.end(), std::size_t{0});
    for (std::size_t entry = 0; entry < count; ++entry) ++begin[key(entry, place) + 1];
    for (std::size_t value = 0; value < range; ++value) begin[value + 1] += begin[value];
    for (const std::size_t entry : order) sorted[begin[key(entry, place)]++] = entry;
    order.swap(sorted);
  }
  return order;
}

}  // namespace delcert
