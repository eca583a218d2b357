#include "kernel/number/big_interval.hpp"

#include <mpfi_io.h>

#include <boost/multiprecision/detail/digits.hpp>

namespace delcert {

namespace {

Rational rational_of(mpfr_srcptr x) {
  if (mpfr_number_p(x) == 0) throw std::domain_error("unbounded interval has no rational endpoint");
  boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off> result;
  mpfr_get_q(result.backend().data(), x);
  return Rational(std::move(result));
}

}  // namespace

BigInterval::Precision::Precision(PrecisionBits bits) : previous_(Wrapped::default_precision()) {
  auto digits = static_cast<unsigned>(boost::multiprecision::detail::digits2_2_10(bits.value));
  while (boost::multiprecision::detail::digits10_2_2(digits) < bits.value) ++digits;
  Wrapped::default_precision(digits);
}

BigInterval::Precision::~Precision() { Wrapped::default_precision(previous_); }

BigInterval::BigInterval(const Rational& x) { mpfi_set_q(raw(), x.gmp()); }

Rational BigInterval::lower() const { return rational_of(&raw()->left); }
Rational BigInterval::upper() const { return rational_of(&raw()->right); }

BigInterval square(const BigInterval& a) {
  BigInterval result;
  mpfi_sqr(result.raw(), a.raw());
  return result;
}

BigInterval square_root(const BigInterval& a) {
  BigInterval clipped = a;
  if (mpfr_sgn(&clipped.raw()->left) < 0) mpfr_set_zero(&clipped.raw()->left, 1);
  if (mpfr_sgn(&clipped.raw()->right) < 0) mpfr_set_zero(&clipped.raw()->right, 1);
  BigInterval result;
  mpfi_sqrt(result.raw(), clipped.raw());
  return result;
}

BigInterval absolute(const BigInterval& a) {
  BigInterval result;
  mpfi_abs(result.raw(), a.raw());
  return result;
}

BigInterval minimum(const BigInterval& a, const BigInterval& b) {
  BigInterval result;
  mpfr_min(&result.raw()->left, &a.raw()->left, &b.raw()->left, MPFR_RNDD);
  mpfr_min(&result.raw()->right, &a.raw()->right, &b.raw()->right, MPFR_RNDU);
  return result;
}

BigInterval maximum(const BigInterval& a, const BigInterval& b) {
  BigInterval result;
  mpfr_max(&result.raw()->left, &a.raw()->left, &b.raw()->left, MPFR_RNDD);
  mpfr_max(&result.raw()->right, &a.raw()->right, &b.raw()->right, MPFR_RNDU);
  return result;
}

Verdict less(const BigInterval& a, const BigInterval& b) {
  if (mpfr_less_p(&a.raw()->right, &b.raw()->left) != 0) return Verdict::proved;
  if (mpfr_greaterequal_p(&a.raw()->left, &b.raw()->right) != 0) return Verdict::refuted;
  return Verdict::undecided;
}

Verdict is_zero(const BigInterval& a) {
  if (mpfr_sgn(&a.raw()->left) > 0 || mpfr_sgn(&a.raw()->right) < 0) return Verdict::refuted;
  return mpfr_zero_p(&a.raw()->left) != 0 && mpfr_zero_p(&a.raw()->right) != 0 ? Verdict::proved : Verdict::undecided;
}

}  // namespace delcert
