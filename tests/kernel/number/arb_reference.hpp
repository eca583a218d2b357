#pragma once

#include <arb.h>

#include <utility>

#include "kernel/number/big_interval.hpp"

namespace delcert::test {

/// A value by Arb, to about 500 bits: a second library beside the one under test.
class ArbReference {
 public:
  static constexpr slong bits = 500;

  ArbReference() { arb_init(value_); }
  explicit ArbReference(const Rational& x) : ArbReference() {
    fmpq_t fraction;
    fmpq_init(fraction);
    fmpq_set_mpq(fraction, x.gmp());
    arb_set_fmpq(value_, fraction, bits);
    fmpq_clear(fraction);
  }
  ArbReference(const ArbReference& other) : ArbReference() { arb_set(value_, other.value_); }
  ArbReference& operator=(const ArbReference& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  ~ArbReference() { arb_clear(value_); }

  /// function(result, this, bits): any of Arb's functions of one variable.
  template <class Function>
  [[nodiscard]] ArbReference with(const Function& function) const {
    ArbReference result;
    function(result.value_, value_, bits);
    return result;
  }
  friend ArbReference operator/(const ArbReference& a, const ArbReference& b) {
    ArbReference result;
    arb_div(result.value_, a.value_, b.value_, bits);
    return result;
  }
  [[nodiscard]] arb_srcptr get() const { return value_; }

  /// Rational bounds, 2⁻⁴⁰⁰ or less apart for values of moderate size.
  [[nodiscard]] Rational lower() const { return ends().first; }
  [[nodiscard]] Rational upper() const { return ends().second; }

 private:
  [[nodiscard]] std::pair<Rational, Rational> ends() const {
    mpfi_t interval;
    mpfi_init2(interval, bits);
    arb_get_interval_mpfr(&interval->left, &interval->right, value_);
    const BigInterval copy = BigInterval::copy_of(interval);
    mpfi_clear(interval);
    return {copy.lower(), copy.upper()};
  }

  arb_t value_;
};

/// Whether the value lies between the bounds, as far as 500 bits can tell.
inline bool lies_between(const ArbReference& value, const Rational& lower, const Rational& upper) {
  return lower <= value.upper() && value.lower() <= upper;
}

}  // namespace delcert::test
