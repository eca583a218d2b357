#pragma once

#include <cmath>

#include "proofs/checker/arithmetic/rational.hpp"

namespace delcert::checker_tests {

/// The value of a finite double.
inline checker::Rational exact(double value) {
  int exponent = 0;
  const auto mantissa = static_cast<long long>(std::ldexp(std::frexp(value, &exponent), 53));
  checker::Rational result;
  fmpz_set_si(fmpq_numref(result.raw()), mantissa);
  const checker::Rational scale = power(checker::Rational(2), std::abs(exponent - 53));
  return exponent >= 53 ? result * scale : result / scale;
}

inline bool contains(const checker::Interval& interval, const checker::Rational& x) {
  const bool above = std::isinf(interval.lower()) || less(x, exact(interval.lower())) == checker::Verdict::refuted;
  return above && (std::isinf(interval.upper()) || less(exact(interval.upper()), x) == checker::Verdict::refuted);
}

}  // namespace delcert::checker_tests
