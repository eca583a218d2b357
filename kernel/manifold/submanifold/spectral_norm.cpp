#include "kernel/manifold/submanifold/spectral_norm.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace delcert {

Interval spectral_norm(std::span<const Interval> entries, std::size_t columns) {
  constexpr int squarings = 6;
  const std::size_t rows = entries.size() / columns;
  const std::size_t order = std::min(rows, columns);
  const auto at = [&](std::size_t k, std::size_t along) -> const Interval& {
    return order == columns ? entries[along * columns + k] : entries[k * columns + along];
  };
  std::vector<Interval> power(order * order, Interval(0));
  for (std::size_t k = 0; k < order; ++k) {
    for (std::size_t l = 0; l < order; ++l) {
      for (std::size_t along = 0; along < entries.size() / order; ++along)
        power[k * order + l] += k == l ? square(at(k, along)) : at(k, along) * at(l, along);
    }
  }
  Interval trace(0);
  for (std::size_t k = 0; k < order; ++k) trace += power[k * order + k];
  const Interval frobenius = square_root(trace);
  if (order == 1 || !(trace.upper() > 0) || !(trace.upper() < std::numeric_limits<double>::infinity()))
    return frobenius;
  const Interval most = Interval::exactly(trace.upper());
  for (Interval& entry : power) entry = entry / most;
  std::vector<Interval> squared(power.size());
  for (int step = 0; step < squarings; ++step) {
    for (std::size_t k = 0; k < order; ++k) {
      for (std::size_t l = 0; l < order; ++l) {
        Interval sum(0);
        for (std::size_t j = 0; j < order; ++j) sum += power[k * order + j] * power[j * order + l];
        squared[k * order + l] = sum;
      }
    }
    power.swap(squared);
  }
  Interval root(0);
  for (std::size_t k = 0; k < order; ++k) root += power[k * order + k];
  root = maximum(root, Interval(0));
  for (int step = 0; step < squarings; ++step) root = square_root(root);
  const Interval result = square_root(root * most);
  return result.upper() < frobenius.upper() ? result : frobenius;
}

}  // namespace delcert
