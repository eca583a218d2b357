#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "kernel/simplex/partial.hpp"
#include "kernel/simplex/symmetric_matrix.hpp"

namespace delcert {

/// How many eigenvalues of a symmetric matrix are negative, zero and positive.
struct Inertia {
  std::size_t negative = 0;
  std::size_t zero = 0;
  std::size_t positive = 0;
  friend bool operator==(const Inertia&, const Inertia&) = default;
};

/// The inertia by Sylvester's law: symmetric elimination with 1×1 pivots that are certainly not 0 and, where there is
/// none, 2×2 pivots of certainly negative determinant, which have one eigenvalue of each sign. Always there on exact
/// scalars; on intervals absent (undecided) when neither kind of pivot is left before the rest is certainly 0.
template <Scalar S>
[[nodiscard]] Partial<Inertia> inertia(SymmetricMatrix<S> matrix) {
  Inertia result;
  std::vector<std::size_t> rest;
  rest.reserve(matrix.order());
  for (std::size_t i = 0; i < matrix.order(); ++i) rest.push_back(i);
  const auto certainly_not_zero = [](const S& x) { return is_refuted(is_zero(x)); };

  const auto eliminate_one = [&]() {
    std::size_t best = rest.size();
    for (std::size_t candidate = 0; candidate < rest.size(); ++candidate) {
      const S& entry = matrix(rest[candidate], rest[candidate]);
      if (!certainly_not_zero(entry)) continue;
      if (best == rest.size() || is_proved(less(square(matrix(rest[best], rest[best])), square(entry)))) {
        best = candidate;
      }
    }
    if (best == rest.size()) return false;
    const std::size_t pivot = rest[best];
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
    ++(is_proved(less(S(0), matrix(pivot, pivot))) ? result.positive : result.negative);
    for (std::size_t a = 0; a < rest.size(); ++a) {
      const S multiplier = matrix(rest[a], pivot) / matrix(pivot, pivot);
      for (std::size_t b = 0; b < a; ++b) {
        matrix(rest[a], rest[b]) = matrix(rest[a], rest[b]) - multiplier * matrix(rest[b], pivot);
      }
      matrix(rest[a], rest[a]) = matrix(rest[a], rest[a]) - square(matrix(rest[a], pivot)) / matrix(pivot, pivot);
    }
    return true;
  };

  const auto eliminate_two = [&]() {
    for (std::size_t second = 1; second < rest.size(); ++second) {
      for (std::size_t first = 0; first < second; ++first) {
        const std::size_t p = rest[first];
        const std::size_t q = rest[second];
        const S determinant = matrix(p, p) * matrix(q, q) - square(matrix(p, q));
        if (!is_proved(less(determinant, S(0)))) continue;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(second));
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(first));
        ++result.positive;
        ++result.negative;
        for (std::size_t a = 0; a < rest.size(); ++a) {
          const std::size_t i = rest[a];
          const S from_p = (matrix(q, q) * matrix(i, p) - matrix(p, q) * matrix(i, q)) / determinant;
          const S from_q = (matrix(p, p) * matrix(i, q) - matrix(p, q) * matrix(i, p)) / determinant;
          for (std::size_t b = 0; b <= a; ++b) {
            const std::size_t j = rest[b];
            matrix(i, j) = matrix(i, j) - from_p * matrix(j, p) - from_q * matrix(j, q);
          }
        }
        return true;
      }
    }
    return false;
  };

  while (!rest.empty() && (eliminate_one() || eliminate_two())) {
  }
  for (const std::size_t i : rest) {
    for (const std::size_t j : rest) {
      if (!is_proved(is_zero(matrix(i, j)))) return Partial<Inertia>::absent(Verdict::undecided);
    }
  }
  result.zero = rest.size();
  return result;
}

}  // namespace delcert
