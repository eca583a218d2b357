#pragma once

#include <gmp.h>

#include <optional>

namespace delcert {

/// The exponent e of a denominator 2^e; nothing for another denominator. Precondition: x is in lowest terms.
[[nodiscard]] inline std::optional<mp_bitcnt_t> dyadic_exponent(mpq_srcptr x) {
  const mp_bitcnt_t exponent = mpz_scan1(mpq_denref(x), 0);
  if (mpz_sizeinbase(mpq_denref(x), 2) != exponent + 1) return std::nullopt;
  return exponent;
}

/// a + b, a − b and a·b in lowest terms. Where both denominators are powers of 2, the result is reduced by a shift;
/// GMP's own functions compute greatest common divisors for all numbers alike. The result may not be an operand.
/// Preconditions: the result is initialised, the operands are in lowest terms.
void add_exactly(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);
void subtract_exactly(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);
void multiply_exactly(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);

}  // namespace delcert
