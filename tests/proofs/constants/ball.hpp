#pragma once

#include <arb.h>
#include <flint/fmpq.h>

#include <string>

#include "kernel/number/rational.hpp"

namespace delcert::test {

/// A real number enclosed by Arb with 512 bits: arithmetic that shares nothing with what it is compared with.
class Ball {
 public:
  Ball() { arb_init(value_); }
  Ball(long integer) : Ball() { arb_set_si(value_, integer); }
  explicit Ball(const Rational& x) : Ball() {
    fmpq_t quotient;
    fmpq_init(quotient);
    fmpq_set_mpq(quotient, x.gmp());
    arb_set_fmpq(value_, quotient, precision);
    fmpq_clear(quotient);
  }
  Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
  Ball& operator=(const Ball& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  static Ball pi() {
    Ball result;
    arb_const_pi(result.value_, precision);
    return result;
  }

  friend Ball operator+(const Ball& a, const Ball& b) { return apply(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return apply(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return apply(arb_mul, a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return apply(arb_div, a, b); }
  friend Ball power(const Ball& a, const Ball& exponent) { return apply(arb_pow, a, exponent); }
  friend Ball minimum(const Ball& a, const Ball& b) { return apply(arb_min, a, b); }
  friend Ball log2(const Ball& a) {
    Ball result;
    arb_log_base_ui(result.value_, a.value_, 2, precision);
    return result;
  }
  friend Ball gamma(const Ball& a) {
    Ball result;
    arb_gamma(result.value_, a.value_, precision);
    return result;
  }

  /// Whether the two can be the same number, and are known to 200 bits.
  friend bool agree(const Ball& a, const Ball& b) {
    const bool known = arb_rel_accuracy_bits(a.value_) > 200 && arb_rel_accuracy_bits(b.value_) > 200;
    const bool both_zero = arb_is_zero(a.value_) && arb_is_zero(b.value_);
    return both_zero || (known && arb_overlaps(a.value_, b.value_));
  }
  /// The ball between two numbers.
  friend Ball hull(const Ball& a, const Ball& b) { return apply(arb_union, a, b); }

  [[nodiscard]] std::string text() const {
    char* digits = arb_get_str(value_, 20, 0);
    std::string result = digits;
    flint_free(digits);
    return result;
  }

 private:
  static constexpr slong precision = 512;
  static Ball apply(void (*operation)(arb_ptr, arb_srcptr, arb_srcptr, slong), const Ball& a, const Ball& b) {
    Ball result;
    operation(result.value_, a.value_, b.value_, precision);
    return result;
  }
  arb_t value_;
};

}  // namespace delcert::test
