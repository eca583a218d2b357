#include "kernel/number/surd.hpp"

namespace delcert {

namespace {

std::optional<Integer> exact_root(const Integer& square) {
  if (mpz_perfect_square_p(square.backend().data()) == 0) return std::nullopt;
  Integer root;
  mpz_sqrt(root.backend().data(), square.backend().data());
  return root;
}

/// √x if it is rational. Precondition: x ≥ 0.
std::optional<Rational> exact_root(const Rational& x) {
  const auto numerator = exact_root(x.numerator());
  if (!numerator) return std::nullopt;
  const auto denominator = exact_root(x.denominator());
  if (!denominator) return std::nullopt;
  return Rational(*numerator, *denominator);
}

int sign_of(const Rational& x) { return x < Rational(0) ? -1 : x == Rational(0) ? 0 : 1; }

}  // namespace

Surd Surd::unknown() {
  Surd result;
  result.known_ = false;
  return result;
}

std::optional<Rational> Surd::rational() const {
  if (!is_rational()) return std::nullopt;
  return factor_;
}

Surd operator+(const Surd& a, const Surd& b) {
  if (!a.known_ || !b.known_) return Surd::unknown();
  if (a.factor_ == Rational(0)) return b;
  if (b.factor_ == Rational(0)) return a;
  if (a.radicand_ == b.radicand_) {
    Rational factor = a.factor_ + b.factor_;
    return factor == Rational(0) ? Surd(0) : Surd(std::move(factor), a.radicand_);
  }
  const auto ratio = exact_root(b.radicand_ / a.radicand_);
  if (!ratio) return Surd::unknown();
  Rational factor = a.factor_ + b.factor_ * *ratio;
  return factor == Rational(0) ? Surd(0) : Surd(std::move(factor), a.radicand_);
}

Surd operator*(const Surd& a, const Surd& b) {
  if (!a.known_ || !b.known_) return Surd::unknown();
  Rational factor = a.factor_ * b.factor_;
  if (factor == Rational(0)) return Surd(0);
  if (a.radicand_ == b.radicand_) return Surd(factor * a.radicand_, Rational(1));
  if (a.is_rational()) return Surd(std::move(factor), b.radicand_);
  if (b.is_rational()) return Surd(std::move(factor), a.radicand_);
  Rational radicand = a.radicand_ * b.radicand_;
  if (const auto root = exact_root(radicand)) return Surd(factor * *root, Rational(1));
  return Surd(std::move(factor), std::move(radicand));
}

Surd operator/(const Surd& a, const Surd& b) {
  if (!a.known_ || !b.known_ || b.factor_ == Rational(0)) return Surd::unknown();
  // 1/(f√r) = √r/(f·r)
  return a * Surd(Rational(1) / (b.factor_ * b.radicand_), b.radicand_);
}

Surd operator-(const Surd& a) {
  Surd result = a;
  result.factor_ = -a.factor_;
  return result;
}

Surd square(const Surd& a) {
  if (!a.known_) return a;
  return Surd(square(a.factor_) * a.radicand_);
}

Surd square_root(const Surd& a) {
  if (!a.is_rational() || a.factor_ < Rational(0)) return Surd::unknown();
  if (a.factor_ == Rational(0)) return Surd(0);
  if (const auto root = exact_root(a.factor_)) return Surd(*root);
  return Surd(Rational(1), a.factor_);
}

Surd absolute(const Surd& a) { return a.factor_ < Rational(0) ? -a : a; }

Surd minimum(const Surd& a, const Surd& b) {
  const Verdict first = less_equal(a, b);
  return is_undecided(first) ? Surd::unknown() : is_proved(first) ? a : b;
}

Surd maximum(const Surd& a, const Surd& b) {
  const Verdict first = less_equal(b, a);
  return is_undecided(first) ? Surd::unknown() : is_proved(first) ? a : b;
}

Verdict less(const Surd& a, const Surd& b) {
  if (!a.known_ || !b.known_) return Verdict::undecided;
  const int left = sign_of(a.factor_);
  const int right = sign_of(b.factor_);
  if (left != right) return verdict_of(left < right);
  if (left == 0) return Verdict::refuted;
  if (a.radicand_ == b.radicand_) return verdict_of(a.factor_ < b.factor_);
  const Rational left_square = square(a.factor_) * a.radicand_;
  const Rational right_square = square(b.factor_) * b.radicand_;
  return verdict_of(left > 0 ? left_square < right_square : right_square < left_square);
}

Verdict is_zero(const Surd& a) { return a.known_ ? verdict_of(a.factor_ == Rational(0)) : Verdict::undecided; }

}  // namespace delcert
