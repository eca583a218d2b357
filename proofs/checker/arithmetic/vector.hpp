#pragma once

#include <array>
#include <cstddef>

namespace delcert::checker {

template <class N>
using Vector = std::array<N, 4>;  // the first m entries count

template <class N>
Vector<N> operator-(const Vector<N>& x, const Vector<N>& y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2], x[3] - y[3]};
}

/// x + a y.
template <class N>
Vector<N> add(const Vector<N>& x, const N& a, const Vector<N>& y) {
  return {x[0] + a * y[0], x[1] + a * y[1], x[2] + a * y[2], x[3] + a * y[3]};
}

template <class N>
N dot(const Vector<N>& x, const Vector<N>& y, std::size_t m) {
  N sum = x[0] * y[0];
  for (std::size_t k = 1; k < m; ++k) sum = sum + x[k] * y[k];
  return sum;
}

}  // namespace delcert::checker
