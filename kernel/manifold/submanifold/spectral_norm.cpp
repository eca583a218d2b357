#include "kernel/manifold/submanifold/spectral_norm.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace delcert {

namespace {

constexpr std::size_t greatest_order = 9;
using Gram = std::array<Interval, greatest_order * greatest_order>;

/// G², G symmetric.
Gram squared(const Gram& g, std::size_t order) {
  Gram result;
  for (std::size_t k = 0; k < order; ++k) {
    for (std::size_t l = k; l < order; ++l) {
      Interval sum = g[k * order] * g[l * order];
      for (std::size_t j = 1; j < order; ++j) sum += g[k * order + j] * g[l * order + j];
      result[k * order + l] = result[l * order + k] = sum;
    }
  }
  return result;
}

Interval trace_of(const Gram& g, std::size_t order) {
  Interval result(0);
  for (std::size_t k = 0; k < order; ++k) result += g[k * order + k];
  return result;
}

}  // namespace

Interval spectral_norm(std::span<const Interval> entries, std::size_t columns) {
  constexpr int squarings = 6;
  const std::size_t rows = entries.size() / columns;
  const std::size_t order = std::min(rows, columns);
  if (order > greatest_order) throw std::invalid_argument("spectral_norm: the matrix has too many rows and columns");
  const auto at = [&](std::size_t k, std::size_t along) -> const Interval& {
    return order == columns ? entries[along * columns + k] : entries[k * columns + along];
  };
  Gram gram;
  for (std::size_t k = 0; k < order; ++k) {
    for (std::size_t l = k; l < order; ++l) {
      Interval sum(0);
      for (std::size_t along = 0; along < entries.size() / order; ++along)
        sum += k == l ? square(at(k, along)) : at(k, along) * at(l, along);
      gram[k * order + l] = gram[l * order + k] = sum;
    }
  }
  const Interval trace = trace_of(gram, order);
  if (order == 1 || !(trace.upper() > 0) || !(trace.upper() < std::numeric_limits<double>::infinity()))
    return square_root(trace);
  if (order == 2) {
    // The greater eigenvalue.
    const Interval root = square_root(square(gram[0] - gram[3]) + Interval(4) * square(gram[1]));
    return square_root(minimum((trace + root) / Interval(2), trace));
  }
  const Interval most = Interval::exactly(trace.upper());
  for (std::size_t k = 0; k < order * order; ++k) gram[k] = gram[k] / most;
  for (int step = 0; step < squarings; ++step) gram = squared(gram, order);
  Interval root = maximum(trace_of(gram, order), Interval(0));
  for (int step = 0; step < squarings; ++step) root = square_root(root);
  return square_root(minimum(root * most, trace));
}

}  // namespace delcert
