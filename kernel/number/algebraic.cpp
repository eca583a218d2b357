#include "kernel/number/algebraic.hpp"

#include <flint/fmpz_poly.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "kernel/number/calcium.hpp"
#include "kernel/number/flint_rational.hpp"

namespace delcert {

struct Algebraic::Value {
  Value() { qqbar_init(number); }
  ~Value() { qqbar_clear(number); }
  Value(const Value&) = delete;
  Value& operator=(const Value&) = delete;

  qqbar_t number;
};

namespace {

void refuse_if_too_large(const qqbar_t a, const qqbar_t b, const char* operation) {
  const long product = qqbar_degree(a) * qqbar_degree(b);
  if (product > Algebraic::greatest_degree)
    throw Algebraic::TooLarge(std::string("algebraic ") + operation + ": degree " + std::to_string(product) +
                              " may be needed, the limit is " + std::to_string(Algebraic::greatest_degree));
}

}  // namespace

Algebraic::Algebraic(int integer) : value_(std::make_unique<Value>()) { qqbar_set_si(value_->number, integer); }

Algebraic::Algebraic(const Rational& x) : value_(std::make_unique<Value>()) {
  FlintRational fraction(x);
  qqbar_set_fmpq(value_->number, fraction.raw());
}

Algebraic::Algebraic(const Algebraic& other) : value_(std::make_unique<Value>()) {
  qqbar_set(value_->number, other.value_->number);
}

Algebraic::Algebraic(Algebraic&& other) noexcept = default;

Algebraic& Algebraic::operator=(const Algebraic& other) {
  if (this != &other) *this = Algebraic(other);
  return *this;
}

Algebraic& Algebraic::operator=(Algebraic&& other) noexcept = default;
Algebraic::~Algebraic() = default;

long Algebraic::degree() const { return qqbar_degree(value_->number); }

Rational Algebraic::rational() const {
  if (degree() != 1) throw std::domain_error("algebraic number of degree " + std::to_string(degree()) + " as rational");
  FlintRational fraction;
  qqbar_get_fmpq(fraction.raw(), value_->number);
  return fraction.rational();
}

BigInterval Algebraic::enclosure() const {
  const auto bits = static_cast<slong>(BigInterval::working_precision().value);
  arb_t ball;
  arb_init(ball);
  qqbar_get_arb(ball, value_->number, bits);
  mpfr_t lower;
  mpfr_t upper;
  mpfr_init2(lower, bits);
  mpfr_init2(upper, bits);
  arb_get_interval_mpfr(lower, upper, ball);
  Rational::Wrapped lower_fraction;
  Rational::Wrapped upper_fraction;
  mpfr_get_q(lower_fraction.backend().data(), lower);
  mpfr_get_q(upper_fraction.backend().data(), upper);
  mpfr_clear(lower);
  mpfr_clear(upper);
  arb_clear(ball);
  return BigInterval::between(Rational(std::move(lower_fraction)), Rational(std::move(upper_fraction)));
}

Algebraic operator+(const Algebraic& a, const Algebraic& b) {
  refuse_if_too_large(a.value_->number, b.value_->number, "sum");
  Algebraic result;
  qqbar_add(result.value_->number, a.value_->number, b.value_->number);
  return result;
}

Algebraic operator-(const Algebraic& a, const Algebraic& b) {
  refuse_if_too_large(a.value_->number, b.value_->number, "difference");
  Algebraic result;
  qqbar_sub(result.value_->number, a.value_->number, b.value_->number);
  return result;
}

Algebraic operator*(const Algebraic& a, const Algebraic& b) {
  refuse_if_too_large(a.value_->number, b.value_->number, "product");
  Algebraic result;
  qqbar_mul(result.value_->number, a.value_->number, b.value_->number);
  return result;
}

Algebraic operator/(const Algebraic& a, const Algebraic& b) {
  if (is_proved(is_zero(b))) throw std::domain_error("algebraic division by 0");
  refuse_if_too_large(a.value_->number, b.value_->number, "quotient");
  Algebraic result;
  qqbar_div(result.value_->number, a.value_->number, b.value_->number);
  return result;
}

Algebraic operator-(const Algebraic& a) {
  Algebraic result;
  qqbar_neg(result.value_->number, a.value_->number);
  return result;
}

// A power stays in the field of a: its degree is at most that of a, however large.
Algebraic square(const Algebraic& a) {
  Algebraic result;
  qqbar_pow_ui(result.value_->number, a.value_->number, 2);
  return result;
}

Algebraic square_root(const Algebraic& a) {
  if (qqbar_sgn_re(a.value_->number) < 0) throw std::domain_error("algebraic square root of a negative number");
  if (2 * a.degree() > Algebraic::greatest_degree)
    throw Algebraic::TooLarge("algebraic square root of a number of degree " + std::to_string(a.degree()));
  Algebraic result;
  qqbar_sqrt(result.value_->number, a.value_->number);
  return result;
}

Algebraic absolute(const Algebraic& a) { return qqbar_sgn_re(a.value_->number) < 0 ? -a : a; }
Algebraic minimum(const Algebraic& a, const Algebraic& b) { return is_proved(less(b, a)) ? b : a; }
Algebraic maximum(const Algebraic& a, const Algebraic& b) { return is_proved(less(a, b)) ? b : a; }

Verdict less(const Algebraic& a, const Algebraic& b) {
  return verdict_of(qqbar_cmp_re(a.value_->number, b.value_->number) < 0);
}

Verdict is_zero(const Algebraic& a) { return verdict_of(qqbar_is_zero(a.value_->number) != 0); }

std::vector<Algebraic> real_roots(std::span<const Rational> coefficients) {
  fmpq_poly_t polynomial;
  fmpq_poly_init(polynomial);
  for (std::size_t power = 0; power < coefficients.size(); ++power)
    set_coefficient(polynomial, static_cast<slong>(power), coefficients[power]);
  const slong degree = fmpq_poly_degree(polynomial);
  if (degree < 0) {
    fmpq_poly_clear(polynomial);
    throw std::invalid_argument("every number is a root of the polynomial 0");
  }
  fmpz_poly_t integral;
  fmpz_poly_init(integral);
  fmpq_poly_get_numerator(integral, polynomial);
  fmpq_poly_clear(polynomial);
  qqbar_ptr roots = _qqbar_vec_init(degree);
  qqbar_roots_fmpz_poly(roots, integral, 0);
  fmpz_poly_clear(integral);
  std::vector<Algebraic> result;
  for (slong at = 0; at < degree; ++at) {
    if (qqbar_is_real(roots + at) == 0) continue;
    result.emplace_back();
    qqbar_set(result.back().value_->number, roots + at);
  }
  _qqbar_vec_clear(roots, degree);
  std::sort(result.begin(), result.end(), [](const Algebraic& a, const Algebraic& b) { return is_proved(less(a, b)); });
  return result;
}

}  // namespace delcert
