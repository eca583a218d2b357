#pragma once

#include <flint/fmpq_poly.h>

#include <memory>
#include <vector>

#include "proofs/checker/arithmetic/ball.hpp"

namespace delcert::checker {

/// The field of the polynomials in t modulo an irreducible one, of which t is a real root.
class NumberField {
 public:
  /// The root between lower and upper. Throws Malformed (form.field) unless the polynomial is irreducible, changes its
  /// sign between the two, and its derivative certainly has none there.
  NumberField(const std::vector<Rational>& coefficients, Rational lower, Rational upper);
  ~NumberField() { fmpq_poly_clear(modulus_); }
  NumberField(const NumberField&) = delete;
  NumberField& operator=(const NumberField&) = delete;

  const fmpq_poly_struct* modulus() const { return modulus_; }
  slong degree() const { return fmpq_poly_degree(modulus_); }
  /// An enclosure of t about as narrow as the precision of balls.
  Ball root() const;

 private:
  fmpq_poly_t modulus_;
  mutable Rational lower_, upper_;  // around the root; halved on demand
  mutable Ball enclosed_;           // what was found for this precision
  mutable slong precision_ = 0;
};

/// An exact element of a number field; without a field, a rational number.
class FieldElement {
 public:
  FieldElement() { fmpq_poly_init(value_); }
  explicit FieldElement(int value) : FieldElement() { fmpq_poly_set_si(value_, value); }
  explicit FieldElement(const Rational& value) : FieldElement() { fmpq_poly_set_fmpq(value_, value.raw()); }
  /// Precondition: fewer coefficients than the degree of the field, or as many.
  FieldElement(const NumberField& field, const std::vector<Rational>& coefficients);
  FieldElement(const FieldElement& other) : field_(other.field_) {
    fmpq_poly_init(value_);
    fmpq_poly_set(value_, other.value_);
  }
  FieldElement& operator=(FieldElement other) noexcept {
    fmpq_poly_swap(value_, other.value_);
    field_ = other.field_;
    return *this;
  }
  ~FieldElement() { fmpq_poly_clear(value_); }

  bool is_zero() const { return fmpq_poly_is_zero(value_) != 0; }
  bool is_rational() const { return fmpq_poly_degree(value_) < 1; }
  /// The coefficient of t^0.
  Rational constant_term() const;
  /// -1, 0 or 1.
  int sign() const;
  Ball enclosure() const;

  friend FieldElement operator+(const FieldElement& a, const FieldElement& b) { return apply(fmpq_poly_add, a, b); }
  friend FieldElement operator-(const FieldElement& a, const FieldElement& b) { return apply(fmpq_poly_sub, a, b); }
  friend FieldElement operator*(const FieldElement& a, const FieldElement& b);
  /// Precondition: b is not 0.
  friend FieldElement operator/(const FieldElement& a, const FieldElement& b);
  friend bool operator==(const FieldElement& a, const FieldElement& b) {
    return fmpq_poly_equal(a.value_, b.value_) != 0;
  }
  /// An order of representations, for containers.
  friend bool operator<(const FieldElement& a, const FieldElement& b) { return fmpq_poly_cmp(a.value_, b.value_) < 0; }

 private:
  static FieldElement apply(void (*operation)(fmpq_poly_t, const fmpq_poly_t, const fmpq_poly_t), const FieldElement& a,
                            const FieldElement& b) {
    FieldElement result;
    result.field_ = a.field_ != nullptr ? a.field_ : b.field_;
    operation(result.value_, a.value_, b.value_);
    return result;
  }

  const NumberField* field_ = nullptr;
  fmpq_poly_t value_;
};

}  // namespace delcert::checker
