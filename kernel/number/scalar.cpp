#include "kernel/number/scalar.hpp"

#include <mpfr.h>

namespace delcert {

namespace {

double rounded(const Rational& x, mpfr_rnd_t direction) {
  mpfr_t value;
  mpfr_init2(value, 53);
  mpfr_set_q(value, x.gmp(), direction);
  const double result = mpfr_get_d(value, direction);
  mpfr_clear(value);
  return result;
}

}  // namespace

template <>
Interval scalar_from<Interval>(const Rational& x) {
  return Interval::between(rounded(x, MPFR_RNDD), rounded(x, MPFR_RNDU));
}

template <>
BigInterval scalar_from<BigInterval>(const Rational& x) {
  return BigInterval(x);
}

}  // namespace delcert
