#pragma once

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>

#include <utility>

#include "kernel/number/rational.hpp"

namespace delcert {

/// A rational number of FLINT, exactly.
class FlintRational {
 public:
  FlintRational() { fmpq_init(value_); }
  explicit FlintRational(const Rational& x) : FlintRational() { fmpq_set_mpq(value_, x.gmp()); }
  FlintRational(const FlintRational& other) : FlintRational() { fmpq_set(value_, other.value_); }
  FlintRational& operator=(const FlintRational&) = delete;
  ~FlintRational() { fmpq_clear(value_); }
  fmpq* raw() { return value_; }
  [[nodiscard]] Rational rational() const {
    Rational::Wrapped result;
    fmpq_get_mpq(result.backend().data(), value_);
    return Rational(std::move(result));
  }

 private:
  fmpq_t value_;
};

/// The coefficient of a power, 0 where there is none.
[[nodiscard]] inline Rational coefficient_of(const fmpq_poly_t polynomial, slong power) {
  FlintRational coefficient;
  fmpq_poly_get_coeff_fmpq(coefficient.raw(), polynomial, power);
  return coefficient.rational();
}

inline void set_coefficient(fmpq_poly_t polynomial, slong power, const Rational& value) {
  FlintRational coefficient(value);
  fmpq_poly_set_coeff_fmpq(polynomial, power, coefficient.raw());
}

}  // namespace delcert
