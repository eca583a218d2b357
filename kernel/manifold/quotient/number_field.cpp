#include "kernel/manifold/quotient/number_field.hpp"

#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <algorithm>
#include <stdexcept>

#include "kernel/number/exact_text.hpp"
#include "kernel/number/flint_rational.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

std::string text_of(const fmpq_poly_t polynomial) {
  std::string result;
  for (slong k = fmpq_poly_degree(polynomial); k >= 0; --k) {
    const Rational coefficient = coefficient_of(polynomial, k);
    if (coefficient == Rational(0)) continue;
    const bool negative = coefficient < Rational(0);
    result += result.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    const Rational size = absolute(coefficient);
    const std::string power = k == 0 ? "" : k == 1 ? "t" : "t^" + std::to_string(k);
    const std::string factor = exact_text(size);
    result += power.empty() ? factor : size == Rational(1) ? power : factor + "*" + power;
  }
  return result.empty() ? "0" : result;
}

/// Throws unless the polynomial is irreducible over ℚ.
void require_irreducible(const fmpq_poly_t polynomial) {
  fmpz_poly_t primitive;
  fmpz_poly_init(primitive);
  fmpq_poly_get_numerator(primitive, polynomial);
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, primitive);
  const bool irreducible = factors->num == 1 && factors->exp[0] == 1;
  std::string factor;
  if (!irreducible) {
    fmpq_poly_t first;
    fmpq_poly_init(first);
    fmpq_poly_set_fmpz_poly(first, factors->p);
    factor = text_of(first);
    fmpq_poly_clear(first);
  }
  fmpz_poly_factor_clear(factors);
  fmpz_poly_clear(primitive);
  if (!irreducible)
    throw InputError("field polynomial " + text_of(polynomial) + " is reducible: " + factor + " divides it");
}

Algebraic root_between(const std::vector<Rational>& coefficients, const Rational& lower, const Rational& upper) {
  std::vector<Algebraic> inside;
  for (const Algebraic& root : real_roots(coefficients)) {
    if (is_proved(less_equal(Algebraic(lower), root)) && is_proved(less_equal(root, Algebraic(upper))))
      inside.push_back(root);
  }
  if (inside.size() != 1)
    throw InputError("field polynomial has " + std::to_string(inside.size()) + " roots in [" + exact_text(lower) +
                     ", " + exact_text(upper) + "], expected one");
  return inside.front();
}

constexpr PrecisionBits usual_precision{128U};

void set_coefficients(fmpq_poly_t polynomial, const std::vector<Rational>& coefficients) {
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    set_coefficient(polynomial, static_cast<slong>(k), coefficients[k]);
}

/// The field in which a result of two operands lives.
const FieldElement::Field& common_field(const FieldElement& a, const FieldElement& b) {
  if (a.field() && b.field() && a.field() != b.field()) throw std::logic_error("elements of two number fields");
  return a.field() ? a.field() : b.field();
}

}  // namespace

NumberField::NumberField(const std::vector<Rational>& coefficients, const Rational& lower, const Rational& upper) {
  fmpq_poly_init(modulus_);
  try {
    set_coefficients(modulus_, coefficients);
    if (fmpq_poly_degree(modulus_) < 1) throw InputError("field polynomial " + text_of(modulus_) + " is constant");
    require_irreducible(modulus_);
    root_ = root_between(coefficients, lower, upper);
    const BigInterval::Precision precision(usual_precision);
    usual_root_ = root_.enclosure();
  } catch (...) {
    fmpq_poly_clear(modulus_);
    throw;
  }
}

NumberField::~NumberField() { fmpq_poly_clear(modulus_); }

long NumberField::degree() const { return fmpq_poly_degree(modulus_); }

BigInterval NumberField::root() const {
  return BigInterval::working_precision() == usual_precision ? usual_root_ : root_.enclosure();
}

std::string NumberField::text() const { return text_of(modulus_); }

FieldElement::FieldElement() { fmpq_poly_init(value_); }
FieldElement::FieldElement(Field field) : field_(std::move(field)) { fmpq_poly_init(value_); }

FieldElement::FieldElement(int integer) : FieldElement() { fmpq_poly_set_si(value_, integer); }

FieldElement::FieldElement(const Rational& x) : FieldElement() { set_coefficient(value_, 0, x); }

FieldElement::FieldElement(Field field, const std::vector<Rational>& coefficients) : FieldElement(std::move(field)) {
  set_coefficients(value_, coefficients);
  reduce();
}

FieldElement::FieldElement(const FieldElement& other) : FieldElement(other.field_) {
  fmpq_poly_set(value_, other.value_);
}

FieldElement::FieldElement(FieldElement&& other) noexcept : field_(std::move(other.field_)) {
  fmpq_poly_init(value_);
  fmpq_poly_swap(value_, other.value_);
}

FieldElement& FieldElement::operator=(const FieldElement& other) {
  if (this != &other) {
    field_ = other.field_;
    fmpq_poly_set(value_, other.value_);
  }
  return *this;
}

FieldElement& FieldElement::operator=(FieldElement&& other) noexcept {
  field_.swap(other.field_);
  fmpq_poly_swap(value_, other.value_);
  return *this;
}

FieldElement::~FieldElement() { fmpq_poly_clear(value_); }

void FieldElement::reduce() {
  if (field_) {
    fmpq_poly_rem(value_, value_, field_->modulus());
  } else if (fmpq_poly_degree(value_) > 0) {
    throw std::logic_error("a polynomial in t without its field");
  }
}

bool FieldElement::is_zero() const { return fmpq_poly_is_zero(value_) != 0; }
bool FieldElement::is_rational() const { return fmpq_poly_degree(value_) <= 0; }

Rational FieldElement::rational() const {
  if (!is_rational()) throw std::domain_error(text() + " is not rational");
  return coefficient_of(value_, 0);
}

std::vector<Rational> FieldElement::coefficients() const {
  std::vector<Rational> result;
  for (slong k = 0; k < fmpq_poly_length(value_); ++k) result.push_back(coefficient_of(value_, k));
  return result;
}

int FieldElement::sign() const {
  if (is_zero()) return 0;
  constexpr unsigned last_precision = 1U << 16U;
  for (unsigned bits = 128; bits <= last_precision; bits *= 2) {
    const BigInterval::Precision precision(PrecisionBits{bits});
    const Verdict positive = less(BigInterval(0), enclosure());
    if (!is_undecided(positive)) return is_proved(positive) ? 1 : -1;
  }
  throw Undecided("sign of " + text() + ": undecided with " + std::to_string(last_precision) + " bits");
}

BigInterval FieldElement::enclosure() const {
  if (is_rational()) return BigInterval(rational());
  const BigInterval t = field_->root();
  BigInterval result(0);
  for (slong k = fmpq_poly_degree(value_); k >= 0; --k) result = result * t + BigInterval(coefficient_of(value_, k));
  return result;
}

std::string FieldElement::text() const { return text_of(value_); }

FieldElement operator+(const FieldElement& a, const FieldElement& b) {
  FieldElement result(common_field(a, b));
  fmpq_poly_add(result.value_, a.value_, b.value_);
  return result;
}

FieldElement operator-(const FieldElement& a, const FieldElement& b) {
  FieldElement result(common_field(a, b));
  fmpq_poly_sub(result.value_, a.value_, b.value_);
  return result;
}

FieldElement operator*(const FieldElement& a, const FieldElement& b) {
  FieldElement result(common_field(a, b));
  fmpq_poly_mul(result.value_, a.value_, b.value_);
  if (result.field_) result.reduce();
  return result;
}

FieldElement operator/(const FieldElement& a, const FieldElement& b) {
  if (b.is_zero()) throw std::domain_error("division of an element of a number field by 0");
  FieldElement inverse(b.field_);
  if (b.is_rational()) {
    inverse = FieldElement(Rational(1) / b.rational());
  } else {
    // f is irreducible, so s·b + r·f = 1 for some s, r.
    fmpq_poly_t one;
    fmpq_poly_t cofactor;
    fmpq_poly_init(one);
    fmpq_poly_init(cofactor);
    fmpq_poly_xgcd(one, inverse.value_, cofactor, b.value_, b.field_->modulus());
    fmpq_poly_clear(one);
    fmpq_poly_clear(cofactor);
  }
  return a * inverse;
}

FieldElement operator-(const FieldElement& a) { return FieldElement(0) - a; }

bool operator==(const FieldElement& a, const FieldElement& b) {
  static_cast<void>(common_field(a, b));
  return fmpq_poly_equal(a.value_, b.value_) != 0;
}

bool precedes(const FieldElement& a, const FieldElement& b) { return fmpq_poly_cmp(a.value_, b.value_) < 0; }

}  // namespace delcert
