#include "proofs/checker/arithmetic/number_field.hpp"

#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <stdexcept>

namespace delcert::checker {
namespace {

bool is_irreducible(const fmpq_poly_t f) {
  fmpz_poly_t numerator;
  fmpz_poly_init(numerator);
  fmpq_poly_get_numerator(numerator, f);
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, numerator);
  const bool result = factors->num == 1 && factors->exp[0] == 1;
  fmpz_poly_factor_clear(factors);
  fmpz_poly_clear(numerator);
  return result;
}

int sign_at(const fmpq_poly_t f, const Rational& x) {
  Rational value;
  fmpq_poly_evaluate_fmpq(value.raw(), f, x.raw());
  return value.sign();
}

Ball value_at(const fmpq_poly_struct* f, const Ball& x) {
  Ball sum(0);
  for (slong k = fmpq_poly_degree(f); k >= 0; --k) {
    Rational coefficient;
    fmpq_poly_get_coeff_fmpq(coefficient.raw(), f, k);
    sum = sum * x + Ball(coefficient);
  }
  return sum;
}

}  // namespace

NumberField::NumberField(const std::vector<Rational>& coefficients, Rational lower, Rational upper)
    : lower_(std::move(lower)), upper_(std::move(upper)) {
  fmpq_poly_init(modulus_);
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    fmpq_poly_set_coeff_fmpq(modulus_, static_cast<slong>(k), coefficients[k].raw());
  const auto require = [this](bool holds, const char* what) {
    if (holds) return;
    fmpq_poly_clear(modulus_);
    throw Malformed("form.field", what);
  };
  require(degree() >= 1 && in_balls(256, [&] { return is_irreducible(modulus_); }),
          "the polynomial of the field is not irreducible");
  require(less(lower_, upper_) == Verdict::proved && sign_at(modulus_, lower_) * sign_at(modulus_, upper_) < 0,
          "the polynomial of the field does not change its sign between the ends of root");
  fmpq_poly_t derivative;
  fmpq_poly_init(derivative);
  fmpq_poly_derivative(derivative, modulus_);
  const bool monotone = in_balls(
      256, [&] { return arb_contains_zero(value_at(derivative, joined(Ball(lower_), Ball(upper_))).raw()) == 0; });
  fmpq_poly_clear(derivative);
  require(monotone, "the ends of root are too far apart: there might be another root between them");
}

Ball NumberField::root() const {
  if (precision_ == Ball::precision) return enclosed_;
  Rational width(1);
  fmpz_mul_2exp(fmpq_denref(width.raw()), fmpq_denref(width.raw()), static_cast<ulong>(Ball::precision));
  while (less(width, upper_ - lower_) == Verdict::proved) {
    const Rational middle = (lower_ + upper_) / Rational(2);
    const int sign = sign_at(modulus_, middle);
    if (sign == 0) {
      lower_ = upper_ = middle;
    } else {
      (sign == sign_at(modulus_, lower_) ? lower_ : upper_) = middle;
    }
  }
  precision_ = Ball::precision;
  return enclosed_ = joined(Ball(lower_), Ball(upper_));
}

FieldElement::FieldElement(const NumberField& field, const std::vector<Rational>& coefficients) : field_(&field) {
  fmpq_poly_init(value_);
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    fmpq_poly_set_coeff_fmpq(value_, static_cast<slong>(k), coefficients[k].raw());
}

Rational FieldElement::constant_term() const {
  Rational result;
  fmpq_poly_get_coeff_fmpq(result.raw(), value_, 0);
  return result;
}

FieldElement operator*(const FieldElement& a, const FieldElement& b) {
  FieldElement result = FieldElement::apply(fmpq_poly_mul, a, b);
  if (result.field_ != nullptr) fmpq_poly_rem(result.value_, result.value_, result.field_->modulus());
  return result;
}

FieldElement operator/(const FieldElement& a, const FieldElement& b) {
  FieldElement inverse = b;
  if (b.is_rational()) {
    fmpq_poly_inv(inverse.value_, b.value_);
  } else {
    fmpq_poly_t divisor, other;  // 1 = inverse b + other f
    fmpq_poly_init(divisor);
    fmpq_poly_init(other);
    fmpq_poly_xgcd(divisor, inverse.value_, other, b.value_, b.field_->modulus());
    fmpq_poly_clear(divisor);
    fmpq_poly_clear(other);
  }
  return a * inverse;
}

Ball FieldElement::enclosure() const {
  return is_rational() ? Ball(constant_term()) : value_at(value_, field_->root());
}

int FieldElement::sign() const {
  if (is_rational()) return constant_term().sign();
  // Not 0, as the polynomial of the field is irreducible: some precision decides.
  for (slong precision = 128; precision <= 1 << 20; precision *= 2) {
    const int found = in_balls(precision, [&] {
      const Ball value = enclosure();
      return arb_is_positive(value.raw()) != 0 ? 1 : arb_is_negative(value.raw()) != 0 ? -1 : 0;
    });
    if (found != 0) return found;
  }
  throw Undecided("the sign of an element of the field");
}

}  // namespace delcert::checker
