#pragma once

#include <flint/fmpq_mpoly.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "proofs/replay/statement.hpp"

namespace delcert::replay {

/// The names of the variables, and FLINT's context for them.
class Variables {
 public:
  explicit Variables(std::vector<std::string> names);
  Variables(const Variables&) = delete;
  Variables& operator=(const Variables&) = delete;
  ~Variables() { fmpq_mpoly_ctx_clear(context_); }
  const std::vector<std::string>& names() const { return names_; }
  const fmpq_mpoly_ctx_struct* raw() const { return context_; }
  /// Throws Malformed for a name that is not among them.
  std::size_t index(const std::string& name) const;

 private:
  std::vector<std::string> names_;
  fmpq_mpoly_ctx_t context_;
};

/// A polynomial with rational coefficients. The variables outlive it.
class Polynomial {
 public:
  explicit Polynomial(const Variables& variables) : variables_(&variables) { fmpq_mpoly_init(value_, variables.raw()); }
  Polynomial(const Variables& variables, const Number& constant);
  Polynomial(const Polynomial& other);
  Polynomial(Polynomial&& other) noexcept;
  Polynomial& operator=(Polynomial other) noexcept;
  ~Polynomial() { fmpq_mpoly_clear(value_, variables_->raw()); }

  /// Reads "-1/2*x^2*y + 3". Throws Malformed.
  static Polynomial read(const std::string& text, const Variables& variables);
  static Polynomial variable(std::size_t index, const Variables& variables);

  bool is_zero() const { return fmpq_mpoly_is_zero(value_, variables_->raw()) != 0; }
  std::optional<Number> constant() const;
  bool has_integer_coefficients() const;
  bool depends_on(std::size_t variable) const;
  Polynomial power(unsigned long exponent) const;
  std::optional<Polynomial> square_root() const;
  /// The quotient if the other divides it.
  std::optional<Polynomial> divided_by(const Polynomial& other) const;
  static Polynomial common_divisor(const Polynomial& a, const Polynomial& b);
  std::vector<std::pair<Polynomial, unsigned long>> factors(Number& constant) const;

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b) { return apply(fmpq_mpoly_add, a, b); }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) { return apply(fmpq_mpoly_sub, a, b); }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) { return apply(fmpq_mpoly_mul, a, b); }
  friend bool operator==(const Polynomial& a, const Polynomial& b) {
    return fmpq_mpoly_equal(a.value_, b.value_, a.variables_->raw()) != 0;
  }

  /// The sign on a box: 2 positive, 1 not negative, −1, −2 accordingly, 0 zero; nothing if the coefficients of
  /// Bernstein have both signs. `sides` are those of the variables: of a squared parameter, of its root.
  std::optional<int> sign_on(const std::vector<Side>& sides) const;

 private:
  template <class Operation>
  static Polynomial apply(const Operation& operation, const Polynomial& a, const Polynomial& b) {
    Polynomial result(*a.variables_);
    operation(result.value_, a.value_, b.value_, a.variables_->raw());
    return result;
  }
  Polynomial shifted(const std::vector<Side>& sides) const;

  const Variables* variables_;
  fmpq_mpoly_t value_;
};

/// The side that the variable runs through: that of the parameter, or of its root, a little more if that is irrational.
Side variable_side(const Side& parameter);

/// A quotient of polynomials, and what has been divided by on the way.
struct Fraction {
  Polynomial numerator;
  Polynomial denominator;
};

/// Terms as quotients of polynomials.
class FractionReader {
 public:
  /// The boxes are those that the parameters run through: they tell which root of a square is meant.
  FractionReader(const Variables& variables, const std::vector<std::vector<Side>>& boxes);

  /// Throws Rejected if it is not a quotient of polynomials.
  Fraction read(const Node& term);
  std::vector<Polynomial> divisors;

 private:
  Fraction quotient(const Fraction& a, const Fraction& b);
  Fraction power(const Fraction& base, const Number& exponent);
  Fraction root(const Fraction& a);
  Fraction extreme(const Node& term);
  Fraction reduced(const Polynomial& numerator, const Polynomial& denominator) const;
  int sign(const Polynomial& p) const;
  int sign(const Fraction& a) const { return sign(a.numerator) * sign(a.denominator); }
  Fraction constant(const Number& value) const { return {{variables_, value}, {variables_, Number(1)}}; }

  const Variables& variables_;
  const std::vector<std::vector<Side>>& boxes_;
};

}  // namespace delcert::replay
