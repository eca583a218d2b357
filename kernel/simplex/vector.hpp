#pragma once

#include <array>
#include <cstddef>

namespace delcert {

/// A point or vector of ℝᵐ in frame coordinates.
template <class S, int m>
using Vector = std::array<S, static_cast<std::size_t>(m)>;

// Inlined everywhere: these few operations are the inner loops of the runs.

template <class S, std::size_t m>
[[nodiscard]] [[gnu::always_inline]] inline std::array<S, m> difference(const std::array<S, m>& a,
                                                                        const std::array<S, m>& b) {
  std::array<S, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = a[axis] - b[axis];
  return result;
}

template <class S, std::size_t m>
[[nodiscard]] [[gnu::always_inline]] inline std::array<S, m> sum(const std::array<S, m>& a, const std::array<S, m>& b) {
  std::array<S, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = a[axis] + b[axis];
  return result;
}

template <class S, std::size_t m>
[[nodiscard]] [[gnu::always_inline]] inline std::array<S, m> scaled(const S& factor, const std::array<S, m>& a) {
  std::array<S, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = factor * a[axis];
  return result;
}

/// Σ aᵢbᵢ: the pairing of a covector with a vector.
template <class S, std::size_t m>
[[nodiscard]] [[gnu::always_inline]] inline S pairing(const std::array<S, m>& a, const std::array<S, m>& b) {
  S result = a[0] * b[0];
  for (std::size_t axis = 1; axis < m; ++axis) result += a[axis] * b[axis];
  return result;
}

/// The covector ν with ν(x) = det(x, e_1, …, e_{m−1}): it vanishes on the span of the m−1 given vectors, and is 0
/// when they are dependent. 1 ≤ m ≤ 4.
template <class S, std::size_t m>
[[nodiscard]] std::array<S, m> wedge(const std::array<std::array<S, m>, m>& e) {
  if constexpr (m == 1) {
    return {S(1)};
  } else if constexpr (m == 2) {
    return {e[0][1], -e[0][0]};
  } else if constexpr (m == 3) {
    return {e[0][1] * e[1][2] - e[0][2] * e[1][1], e[0][2] * e[1][0] - e[0][0] * e[1][2],
            e[0][0] * e[1][1] - e[0][1] * e[1][0]};
  } else {
    static_assert(m == 4);
    const auto minor = [&e](std::size_t a, std::size_t b, std::size_t c) {
      return e[0][a] * (e[1][b] * e[2][c] - e[1][c] * e[2][b]) - e[0][b] * (e[1][a] * e[2][c] - e[1][c] * e[2][a]) +
             e[0][c] * (e[1][a] * e[2][b] - e[1][b] * e[2][a]);
    };
    return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
  }
}

}  // namespace delcert
