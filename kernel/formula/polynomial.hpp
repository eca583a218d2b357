#pragma once

#include <flint/fmpq_mpoly.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// The variables of polynomials: x_0, x_1 … by name.
class PolynomialRing {
 public:
  explicit PolynomialRing(std::vector<std::string> names);
  PolynomialRing(const PolynomialRing&) = delete;
  PolynomialRing& operator=(const PolynomialRing&) = delete;
  ~PolynomialRing();

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] std::size_t variable_count() const { return names_.size(); }
  [[nodiscard]] const fmpq_mpoly_ctx_struct* raw() const { return context_; }

 private:
  std::vector<std::string> names_;
  fmpq_mpoly_ctx_t context_;
};

using RingPointer = std::shared_ptr<const PolynomialRing>;

/// A polynomial with rational coefficients in the variables of a ring (FLINT's fmpq_mpoly, a sum of terms), exact.
/// Precondition of all operations on two: the same ring.
class Polynomial {
 public:
  struct Term {
    Rational coefficient;
    std::vector<unsigned long> exponents;  ///< one for each variable
  };
  struct Factor;
  struct Factors;
  /// FLINT has given up.
  class NotFactored : public std::runtime_error {
   public:
    using std::runtime_error::runtime_error;
  };

  explicit Polynomial(RingPointer ring);
  Polynomial(RingPointer ring, const Rational& constant);
  [[nodiscard]] static Polynomial variable(RingPointer ring, std::size_t index);

  Polynomial(const Polynomial& other);
  Polynomial(Polynomial&& other) noexcept;
  Polynomial& operator=(Polynomial other) noexcept;
  ~Polynomial();

  [[nodiscard]] const RingPointer& ring() const { return ring_; }
  [[nodiscard]] bool is_zero() const;
  /// The number if it is one.
  [[nodiscard]] std::optional<Rational> constant() const;
  [[nodiscard]] std::size_t term_count() const;
  /// In the order of FLINT's lexicographic monomial order, the greatest first.
  [[nodiscard]] std::vector<Term> terms() const;
  /// The degree in each variable; 0 for the zero polynomial.
  [[nodiscard]] std::vector<unsigned long> degrees() const;
  /// The exact value. Precondition: as many numbers as there are variables.
  [[nodiscard]] Rational at(const std::vector<Rational>& x) const;
  /// Such as "-1/2*x^2*y + 3".
  [[nodiscard]] std::string text() const;

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a);
  friend bool operator==(const Polynomial& a, const Polynomial& b);

  /// Throws std::length_error if it would not fit into memory.
  [[nodiscard]] Polynomial power(unsigned long exponent) const;
  /// The polynomial whose square this is, with a positive leading coefficient, if there is one.
  [[nodiscard]] std::optional<Polynomial> square_root() const;
  /// The greatest common divisor; 0 of zeros only.
  [[nodiscard]] static Polynomial common_divisor(const Polynomial& a, const Polynomial& b);
  /// a/b. Precondition: b divides a.
  [[nodiscard]] static Polynomial exact_quotient(const Polynomial& a, const Polynomial& b);
  /// A constant times powers of different irreducible polynomials that have integer coefficients without a common
  /// divisor and a positive leading one. Precondition: not 0. Throws NotFactored.
  [[nodiscard]] Factors factors() const;

 private:
  RingPointer ring_;
  fmpq_mpoly_t value_;
};

struct Polynomial::Factor {
  Polynomial base;
  unsigned long exponent = 1;
};

struct Polynomial::Factors {
  Rational constant;
  std::vector<Factor> powers;
};

}  // namespace delcert
