#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace delcert {

/// std::sort for values that come first by a number below about their count, which few of them share: they are put into
/// the place of their number without comparisons, and only those that share one are compared. Precondition:
/// number(a) < number(b) implies less(a, b).
template <class T, class Number, class Less = std::less<>>
void sort_by_number(std::vector<T>& values, const Number& number, const Less& less = {}) {
  std::size_t numbers = 0;
  for (const T& value : values) numbers = std::max(numbers, std::size_t{number(value)} + 1);
  std::vector<std::size_t> end(numbers, 0);  // of the values with a number, once they are placed
  for (const T& value : values) ++end[number(value)];
  std::size_t sum = 0;
  for (std::size_t& place : end) sum += std::exchange(place, sum);
  std::vector<T> placed(values.size());
  for (T& value : values) placed[end[number(value)]++] = std::move(value);
  values = std::move(placed);
  std::size_t begin = 0;
  for (const std::size_t last : end) {
    const auto at = [&](std::size_t place) { return values.begin() + static_cast<std::ptrdiff_t>(place); };
    if (last - begin > 1) std::sort(at(begin), at(last), less);
    begin = last;
  }
}

}  // namespace delcert
