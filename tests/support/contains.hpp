#pragma once

#include <cmath>
#include <limits>

#include "kernel/number/big_interval.hpp"
#include "kernel/number/interval.hpp"
#include "kernel/number/rational.hpp"

namespace delcert {

/// Whether x lies in the interval, whose endpoints may be infinite but not NaN.
inline bool contains(const Interval& interval, const Rational& x) {
  const double lower = interval.lower();
  const double upper = interval.upper();
  if (std::isnan(lower) || std::isnan(upper)) return false;
  const bool above =
      lower == -std::numeric_limits<double>::infinity() || (std::isfinite(lower) && Rational::exactly(lower) <= x);
  const bool below =
      upper == std::numeric_limits<double>::infinity() || (std::isfinite(upper) && x <= Rational::exactly(upper));
  return above && below;
}

inline bool contains(const BigInterval& interval, const Rational& x) {
  const mpfi_srcptr raw = interval.mpfi();
  if (mpfr_nan_p(&raw->left) != 0 || mpfr_nan_p(&raw->right) != 0) return false;
  return mpfr_cmp_q(&raw->left, x.gmp()) <= 0 && mpfr_cmp_q(&raw->right, x.gmp()) >= 0;
}

}  // namespace delcert
