#include "kernel/number/dyadic_arithmetic.hpp"

#include <algorithm>

namespace delcert {

namespace {

/// The numerator of the result is set: what is the number over 2^exponent, in lowest terms.
void divide_by_power_of_two(mpq_ptr result, mp_bitcnt_t exponent) {
  mpz_ptr numerator = mpq_numref(result);
  if (mpz_sgn(numerator) == 0) {
    exponent = 0;
  } else if (exponent > 0) {
    const mp_bitcnt_t common = std::min(mpz_scan1(numerator, 0), exponent);
    if (common > 0) mpz_tdiv_q_2exp(numerator, numerator, common);
    exponent -= common;
  }
  mpz_set_ui(mpq_denref(result), 1);
  if (exponent > 0) mpz_mul_2exp(mpq_denref(result), mpq_denref(result), exponent);
}

using OfIntegers = void (*)(mpz_ptr, mpz_srcptr, mpz_srcptr);

/// `operation` is addition or subtraction.
void combine_dyadics(mpq_ptr result, mpq_srcptr a, mp_bitcnt_t exponent_of_a, mpq_srcptr b, mp_bitcnt_t exponent_of_b,
                     OfIntegers operation) {
  mpz_ptr numerator = mpq_numref(result);
  if (exponent_of_a >= exponent_of_b) {
    mpz_mul_2exp(numerator, mpq_numref(b), exponent_of_a - exponent_of_b);
    operation(numerator, mpq_numref(a), numerator);
  } else {
    mpz_mul_2exp(numerator, mpq_numref(a), exponent_of_b - exponent_of_a);
    operation(numerator, numerator, mpq_numref(b));
  }
  divide_by_power_of_two(result, std::max(exponent_of_a, exponent_of_b));
}

}  // namespace

void add_exactly(mpq_ptr result, mpq_srcptr a, mpq_srcptr b) {
  const auto p = dyadic_exponent(a);
  const auto q = dyadic_exponent(b);
  if (p && q) return combine_dyadics(result, a, *p, b, *q, mpz_add);
  mpq_add(result, a, b);
}

void subtract_exactly(mpq_ptr result, mpq_srcptr a, mpq_srcptr b) {
  const auto p = dyadic_exponent(a);
  const auto q = dyadic_exponent(b);
  if (p && q) return combine_dyadics(result, a, *p, b, *q, mpz_sub);
  mpq_sub(result, a, b);
}

void multiply_exactly(mpq_ptr result, mpq_srcptr a, mpq_srcptr b) {
  const auto p = dyadic_exponent(a);
  const auto q = dyadic_exponent(b);
  if (!p || !q) return mpq_mul(result, a, b);
  mpz_mul(mpq_numref(result), mpq_numref(a), mpq_numref(b));
  divide_by_power_of_two(result, *p + *q);
}

}  // namespace delcert
