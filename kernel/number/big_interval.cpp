#include "kernel/number/big_interval.hpp"

#include <stdexcept>

#include "kernel/number/dyadic_arithmetic.hpp"

namespace delcert {

namespace {

PrecisionBits& precision_of_this_thread() {
  thread_local PrecisionBits precision(128);
  return precision;
}

mpfr_prec_t digits_of(PrecisionBits precision) { return static_cast<mpfr_prec_t>(precision.value); }

/// x rounded; without a division where the denominator is a power of two.
void set(mpfr_ptr result, const Rational& x, mpfr_rnd_t direction) {
  if (const auto exponent = dyadic_exponent(x.gmp())) {
    mpfr_set_z_2exp(result, mpq_numref(x.gmp()), -static_cast<mpfr_exp_t>(*exponent), direction);
  } else {
    mpfr_set_q(result, x.gmp(), direction);
  }
}

Rational rational_of(mpfr_srcptr x) {
  if (mpfr_number_p(x) == 0) throw std::domain_error("unbounded interval has no rational endpoint");
  Rational::Wrapped result;
  mpfr_get_q(result.backend().data(), x);
  return Rational(std::move(result));
}

}  // namespace

BigInterval::Precision::Precision(PrecisionBits bits) : previous_(precision_of_this_thread()) {
  if (bits < PrecisionBits(2) || bits > PrecisionBits(1U << 20U))
    throw std::domain_error("working precision out of range: " + std::to_string(bits.value) + " bits");
  precision_of_this_thread() = bits;
}

BigInterval::Precision::~Precision() { precision_of_this_thread() = previous_; }

PrecisionBits BigInterval::working_precision() { return precision_of_this_thread(); }

BigInterval::BigInterval(Unset) noexcept { mpfi_init2(value_, digits_of(precision_of_this_thread())); }

BigInterval::BigInterval(int integer) noexcept : BigInterval(Unset{}) { mpfi_set_si(value_, integer); }

BigInterval::BigInterval(const Rational& x) noexcept : BigInterval(Unset{}) {
  set(&value_->left, x, MPFR_RNDD);
  set(&value_->right, x, MPFR_RNDU);
}

BigInterval::BigInterval(const BigInterval& other) noexcept {
  mpfi_init2(value_, mpfi_get_prec(other.value_));
  mpfi_set(value_, other.value_);
}

// What was moved from holds no limbs: it can be assigned to and destroyed.
BigInterval::BigInterval(BigInterval&& other) noexcept {
  value_[0] = other.value_[0];
  other.value_[0].left._mpfr_d = nullptr;
}

BigInterval& BigInterval::operator=(const BigInterval& other) noexcept {
  if (this != &other) *this = BigInterval(other);
  return *this;
}

BigInterval& BigInterval::operator=(BigInterval&& other) noexcept {
  if (this != &other) {
    release();
    value_[0] = other.value_[0];
    other.value_[0].left._mpfr_d = nullptr;
  }
  return *this;
}

BigInterval::~BigInterval() { release(); }

void BigInterval::release() noexcept {
  if (value_[0].left._mpfr_d != nullptr) mpfi_clear(value_);
}

BigInterval BigInterval::between(const Rational& lower, const Rational& upper) {
  BigInterval result(Unset{});
  set(&result.value_->left, lower, MPFR_RNDD);
  set(&result.value_->right, upper, MPFR_RNDU);
  return result;
}

BigInterval BigInterval::copy_of(mpfi_srcptr value) {
  BigInterval result(Unset{});
  mpfi_set_prec(result.value_, mpfi_get_prec(value));
  mpfi_set(result.value_, value);
  return result;
}

Rational BigInterval::lower() const { return rational_of(&value_->left); }
Rational BigInterval::upper() const { return rational_of(&value_->right); }
bool BigInterval::is_bounded() const { return mpfi_bounded_p(value_) != 0; }

BigInterval operator+(const BigInterval& a, const BigInterval& b) noexcept {
  BigInterval result(BigInterval::Unset{});
  mpfi_add(result.value_, a.value_, b.value_);
  return result;
}

BigInterval operator-(const BigInterval& a, const BigInterval& b) noexcept {
  BigInterval result(BigInterval::Unset{});
  mpfi_sub(result.value_, a.value_, b.value_);
  return result;
}

BigInterval operator*(const BigInterval& a, const BigInterval& b) noexcept {
  BigInterval result(BigInterval::Unset{});
  mpfi_mul(result.value_, a.value_, b.value_);
  return result;
}

BigInterval operator/(const BigInterval& a, const BigInterval& b) noexcept {
  BigInterval result(BigInterval::Unset{});
  if (is_refuted(is_zero(b))) {
    mpfi_div(result.value_, a.value_, b.value_);
  } else {
    mpfr_set_inf(&result.value_->left, -1);
    mpfr_set_inf(&result.value_->right, 1);
  }
  return result;
}

BigInterval operator-(const BigInterval& a) noexcept {
  BigInterval result(BigInterval::Unset{});
  mpfi_neg(result.value_, a.value_);
  return result;
}

BigInterval square(const BigInterval& a) noexcept {
  BigInterval result(BigInterval::Unset{});
  mpfi_sqr(result.value_, a.value_);
  return result;
}

BigInterval square_root(const BigInterval& a) noexcept {
  BigInterval clipped = a;
  if (mpfr_sgn(&clipped.value_->left) < 0) mpfr_set_zero(&clipped.value_->left, 1);
  if (mpfr_sgn(&clipped.value_->right) < 0) mpfr_set_zero(&clipped.value_->right, 1);
  BigInterval result(BigInterval::Unset{});
  mpfi_sqrt(result.value_, clipped.value_);
  return result;
}

BigInterval absolute(const BigInterval& a) noexcept {
  BigInterval result(BigInterval::Unset{});
  mpfi_abs(result.value_, a.value_);
  return result;
}

BigInterval minimum(const BigInterval& a, const BigInterval& b) noexcept {
  BigInterval result(BigInterval::Unset{});
  mpfr_min(&result.value_->left, &a.value_->left, &b.value_->left, MPFR_RNDD);
  mpfr_min(&result.value_->right, &a.value_->right, &b.value_->right, MPFR_RNDU);
  return result;
}

BigInterval maximum(const BigInterval& a, const BigInterval& b) noexcept {
  BigInterval result(BigInterval::Unset{});
  mpfr_max(&result.value_->left, &a.value_->left, &b.value_->left, MPFR_RNDD);
  mpfr_max(&result.value_->right, &a.value_->right, &b.value_->right, MPFR_RNDU);
  return result;
}

Verdict less(const BigInterval& a, const BigInterval& b) noexcept {
  if (mpfr_less_p(&a.value_->right, &b.value_->left) != 0) return Verdict::proved;
  if (mpfr_greaterequal_p(&a.value_->left, &b.value_->right) != 0) return Verdict::refuted;
  return Verdict::undecided;
}

Verdict is_zero(const BigInterval& a) noexcept {
  if (mpfr_sgn(&a.value_->left) > 0 || mpfr_sgn(&a.value_->right) < 0) return Verdict::refuted;
  return mpfr_zero_p(&a.value_->left) != 0 && mpfr_zero_p(&a.value_->right) != 0 ? Verdict::proved : Verdict::undecided;
}

}  // namespace delcert
