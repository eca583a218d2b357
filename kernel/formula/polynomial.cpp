#include "kernel/formula/polynomial.hpp"

#include <flint/fmpq_mpoly_factor.h>

#include <stdexcept>

#include "kernel/number/flint_rational.hpp"

namespace delcert {

PolynomialRing::PolynomialRing(std::vector<std::string> names) : names_(std::move(names)) {
  // A ring of constants needs a variable all the same.
  if (names_.empty()) names_.emplace_back("_");
  fmpq_mpoly_ctx_init(context_, static_cast<slong>(names_.size()), ORD_LEX);
}

PolynomialRing::~PolynomialRing() { fmpq_mpoly_ctx_clear(context_); }

Polynomial::Polynomial(RingPointer ring) : ring_(std::move(ring)) { fmpq_mpoly_init(value_, ring_->raw()); }

Polynomial::Polynomial(RingPointer ring, const Rational& constant) : Polynomial(std::move(ring)) {
  FlintRational value(constant);
  fmpq_mpoly_set_fmpq(value_, value.raw(), ring_->raw());
}

Polynomial Polynomial::variable(RingPointer ring, std::size_t index) {
  Polynomial result(std::move(ring));
  fmpq_mpoly_gen(result.value_, static_cast<slong>(index), result.ring_->raw());
  return result;
}

Polynomial::Polynomial(const Polynomial& other) : Polynomial(other.ring_) {
  fmpq_mpoly_set(value_, other.value_, ring_->raw());
}

// The other one needs its ring to be destroyed.
Polynomial::Polynomial(Polynomial&& other) noexcept : Polynomial(other.ring_) {
  fmpq_mpoly_swap(value_, other.value_, ring_->raw());
}

Polynomial& Polynomial::operator=(Polynomial other) noexcept {
  fmpq_mpoly_swap(value_, other.value_, ring_->raw());
  std::swap(ring_, other.ring_);
  return *this;
}

Polynomial::~Polynomial() { fmpq_mpoly_clear(value_, ring_->raw()); }

bool Polynomial::is_zero() const { return fmpq_mpoly_is_zero(value_, ring_->raw()) != 0; }

std::optional<Rational> Polynomial::constant() const {
  if (fmpq_mpoly_is_fmpq(value_, ring_->raw()) == 0) return std::nullopt;
  FlintRational result;
  fmpq_mpoly_get_fmpq(result.raw(), value_, ring_->raw());
  return result.rational();
}

std::size_t Polynomial::term_count() const { return static_cast<std::size_t>(fmpq_mpoly_length(value_, ring_->raw())); }

std::vector<Polynomial::Term> Polynomial::terms() const {
  std::vector<Term> result;
  FlintRational coefficient;
  for (std::size_t at = 0; at < term_count(); ++at) {
    fmpq_mpoly_get_term_coeff_fmpq(coefficient.raw(), value_, static_cast<slong>(at), ring_->raw());
    Term term{coefficient.rational(), std::vector<unsigned long>(ring_->variable_count())};
    fmpq_mpoly_get_term_exp_ui(term.exponents.data(), value_, static_cast<slong>(at), ring_->raw());
    result.push_back(std::move(term));
  }
  return result;
}

std::vector<unsigned long> Polynomial::degrees() const {
  std::vector<slong> found(ring_->variable_count());
  fmpq_mpoly_degrees_si(found.data(), value_, ring_->raw());
  std::vector<unsigned long> result;
  for (const slong degree : found) result.push_back(degree < 0 ? 0UL : static_cast<unsigned long>(degree));
  return result;
}

Rational Polynomial::at(const std::vector<Rational>& x) const {
  std::vector<FlintRational> values;
  values.reserve(x.size());
  std::vector<fmpq*> places;
  for (const Rational& coordinate : x) places.push_back(values.emplace_back(coordinate).raw());
  FlintRational result;
  if (fmpq_mpoly_evaluate_all_fmpq(result.raw(), value_, places.data(), ring_->raw()) == 0)
    throw std::length_error("a power does not fit into memory");
  return result.rational();
}

std::string Polynomial::text() const {
  std::string result;
  for (const Term& term : terms()) {
    const bool negative = term.coefficient < Rational(0);
    const Rational size = absolute(term.coefficient);
    std::string product;
    for (std::size_t i = 0; i < term.exponents.size(); ++i) {
      if (term.exponents[i] == 0) continue;
      product += (product.empty() ? "" : "*") + ring_->names()[i];
      if (term.exponents[i] > 1) product += "^" + std::to_string(term.exponents[i]);
    }
    const Integer denominator = size.denominator();
    std::string number = size.numerator().str() + (denominator == 1 ? "" : "/" + denominator.str());
    if (!product.empty() && size == Rational(1)) number.clear();
    result += result.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    result += number + (number.empty() || product.empty() ? "" : "*") + product;
  }
  return result.empty() ? "0" : result;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.ring_);
  fmpq_mpoly_add(result.value_, a.value_, b.value_, a.ring_->raw());
  return result;
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.ring_);
  fmpq_mpoly_sub(result.value_, a.value_, b.value_, a.ring_->raw());
  return result;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.ring_);
  fmpq_mpoly_mul(result.value_, a.value_, b.value_, a.ring_->raw());
  return result;
}

Polynomial operator-(const Polynomial& a) {
  Polynomial result(a.ring_);
  fmpq_mpoly_neg(result.value_, a.value_, a.ring_->raw());
  return result;
}

bool operator==(const Polynomial& a, const Polynomial& b) {
  return fmpq_mpoly_equal(a.value_, b.value_, a.ring_->raw()) != 0;
}

Polynomial Polynomial::power(unsigned long exponent) const {
  Polynomial result(ring_);
  if (fmpq_mpoly_pow_ui(result.value_, value_, exponent, ring_->raw()) == 0) {
    throw std::length_error("a power of a polynomial that does not fit into memory");
  }
  return result;
}

std::optional<Polynomial> Polynomial::square_root() const {
  Polynomial result(ring_);
  if (fmpq_mpoly_sqrt(result.value_, value_, ring_->raw()) == 0) return std::nullopt;
  const bool negative = !result.is_zero() && result.terms().front().coefficient < Rational(0);
  return negative ? -result : result;
}

Polynomial Polynomial::common_divisor(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.ring_);
  if (fmpq_mpoly_gcd(result.value_, a.value_, b.value_, a.ring_->raw()) == 0) {
    return Polynomial(a.ring_, Rational(1));
  }
  return result;
}

Polynomial Polynomial::exact_quotient(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.ring_);
  if (fmpq_mpoly_divides(result.value_, a.value_, b.value_, a.ring_->raw()) == 0) {
    throw std::domain_error("a division of polynomials that leaves a remainder");
  }
  return result;
}

Polynomial::Factors Polynomial::factors() const {
  fmpq_mpoly_factor_t found;
  fmpq_mpoly_factor_init(found, ring_->raw());
  const int done = fmpq_mpoly_factor(found, value_, ring_->raw());
  Factors result;
  if (done != 0) {
    FlintRational constant;
    fmpq_mpoly_factor_get_constant_fmpq(constant.raw(), found, ring_->raw());
    result.constant = constant.rational();
    for (slong at = 0; at < fmpq_mpoly_factor_length(found, ring_->raw()); ++at) {
      Polynomial base(ring_);
      fmpq_mpoly_factor_get_base(base.value_, found, at, ring_->raw());
      const auto exponent = static_cast<unsigned long>(fmpq_mpoly_factor_get_exp_si(found, at, ring_->raw()));
      // FLINT's factors are monic; ours have integer coefficients.
      FlintRational content;
      fmpq_mpoly_content(content.raw(), base.value_, ring_->raw());
      Rational scale = content.rational();
      if (base.terms().front().coefficient < Rational(0)) scale = -scale;
      FlintRational divisor(scale);
      fmpq_mpoly_scalar_div_fmpq(base.value_, base.value_, divisor.raw(), ring_->raw());
      result.constant *= delcert::power(scale, static_cast<long>(exponent));
      result.powers.push_back({std::move(base), exponent});
    }
  }
  fmpq_mpoly_factor_clear(found, ring_->raw());
  if (done == 0) throw NotFactored("a polynomial that FLINT does not factor");
  return result;
}

}  // namespace delcert
