#pragma once

#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// A point or vector of some ℝᵐ by its coordinates, m known at run time.
using ExactPoint = std::vector<Rational>;

/// ⟨a, b⟩. Precondition: the same dimension.
[[nodiscard]] inline Rational pairing(const ExactPoint& a, const ExactPoint& b) {
  Rational result(0);
  for (std::size_t axis = 0; axis < a.size(); ++axis) result += a[axis] * b[axis];
  return result;
}

/// a + factor · b. Precondition: the same dimension.
[[nodiscard]] inline ExactPoint combined(const ExactPoint& a, const Rational& factor, const ExactPoint& b) {
  ExactPoint result = a;
  for (std::size_t axis = 0; axis < a.size(); ++axis) result[axis] += factor * b[axis];
  return result;
}

}  // namespace delcert
