#pragma once

#include <concepts>
#include <memory>
#include <span>
#include <vector>

#include "kernel/number/scalar.hpp"
#include "support/error.hpp"

namespace delcert {

/// A real algebraic number: the rung on which decisions about quantities with roots in them end. Over Calcium's
/// `qqbar`, a minimal polynomial with an enclosure of the root that is meant, so equality is decided, not guessed.
///
/// Every operation is exact. The degree of a result may be the product of the operands' degrees, and beyond
/// `greatest_degree` the time would not be worth the answer: there an operation throws `Algebraic::TooLarge`, which
/// `decide_statement` reports as undecided. A number that was moved from can be assigned to and destroyed only.
class Algebraic {
 public:
  class TooLarge : public Undecided {
   public:
    using Undecided::Undecided;
  };
  /// The largest product of the operands' degrees that an operation takes on.
  static constexpr long greatest_degree = 128;

  Algebraic() : Algebraic(0) {}
  Algebraic(int integer);
  explicit Algebraic(const Rational& x);

  template <std::floating_point T>
  Algebraic(T) = delete;

  Algebraic(const Algebraic& other);
  Algebraic(Algebraic&& other) noexcept;
  Algebraic& operator=(const Algebraic& other);
  Algebraic& operator=(Algebraic&& other) noexcept;
  ~Algebraic();

  /// The degree of the minimal polynomial: 1 for a rational number.
  [[nodiscard]] long degree() const;
  /// The number itself if it is rational; throws std::domain_error if not.
  [[nodiscard]] Rational rational() const;
  /// An interval around the number, about as narrow as the working precision of BigInterval allows.
  [[nodiscard]] BigInterval enclosure() const;

  friend Algebraic operator+(const Algebraic& a, const Algebraic& b);
  friend Algebraic operator-(const Algebraic& a, const Algebraic& b);
  friend Algebraic operator*(const Algebraic& a, const Algebraic& b);
  /// Throws std::domain_error if b is 0.
  friend Algebraic operator/(const Algebraic& a, const Algebraic& b);
  friend Algebraic operator-(const Algebraic& a);
  Algebraic& operator+=(const Algebraic& b) { return *this = *this + b; }
  Algebraic& operator-=(const Algebraic& b) { return *this = *this - b; }
  Algebraic& operator*=(const Algebraic& b) { return *this = *this * b; }
  Algebraic& operator/=(const Algebraic& b) { return *this = *this / b; }

  friend Algebraic square(const Algebraic& a);
  /// The root that is not negative. Throws std::domain_error if a is negative.
  friend Algebraic square_root(const Algebraic& a);
  friend Algebraic absolute(const Algebraic& a);
  friend Algebraic minimum(const Algebraic& a, const Algebraic& b);
  friend Algebraic maximum(const Algebraic& a, const Algebraic& b);

  /// Verdicts are never undecided.
  friend Verdict less(const Algebraic& a, const Algebraic& b);
  friend Verdict less_equal(const Algebraic& a, const Algebraic& b) { return negation(less(b, a)); }
  friend Verdict is_zero(const Algebraic& a);

  /// The real roots of Σ coefficients[i] xⁱ in increasing order, each as often as its multiplicity.
  /// Throws std::invalid_argument if there is no coefficient but 0.
  friend std::vector<Algebraic> real_roots(std::span<const Rational> coefficients);

 private:
  struct Value;
  std::unique_ptr<Value> value_;
};

[[nodiscard]] std::vector<Algebraic> real_roots(std::span<const Rational> coefficients);

template <>
[[nodiscard]] inline Algebraic scalar_from<Algebraic>(const Rational& x) {
  return Algebraic(x);
}

}  // namespace delcert
