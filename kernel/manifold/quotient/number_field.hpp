#pragma once

#include <flint/fmpq_poly.h>

#include <memory>
#include <string>
#include <vector>

#include "kernel/number/algebraic.hpp"

namespace delcert {

class FieldElement;

/// A number field K = ℚ[t]/(f) with one of its embeddings in ℝ: t is a real root of the irreducible polynomial f.
class NumberField {
 public:
  /// f = Σ coefficients[i] tⁱ and the root that is meant, the only one in [lower, upper]. Throws InputError if f has
  /// degree 0, is reducible (and says by which factor), or has another number of roots there (and says how many).
  NumberField(const std::vector<Rational>& coefficients, const Rational& lower, const Rational& upper);
  ~NumberField();
  NumberField(const NumberField&) = delete;
  NumberField& operator=(const NumberField&) = delete;

  [[nodiscard]] long degree() const;
  /// An enclosure of t, about as narrow as the working precision allows.
  [[nodiscard]] BigInterval root() const;
  [[nodiscard]] const fmpq_poly_struct* modulus() const { return modulus_; }
  /// f, written in t.
  [[nodiscard]] std::string text() const;

 private:
  fmpq_poly_t modulus_;
  Algebraic root_;
  BigInterval usual_root_;  // at the precision that nearly all decisions need
};

/// An exact element of a number field; without a field, of ℚ, which is in all of them.
///
/// Every operation is exact, and equality is decided. Elements of two different fields cannot meet: std::logic_error.
class FieldElement {
 public:
  using Field = std::shared_ptr<const NumberField>;

  FieldElement();
  FieldElement(int integer);
  explicit FieldElement(const Rational& x);
  /// Σ coefficients[i] tⁱ.
  FieldElement(Field field, const std::vector<Rational>& coefficients);
  FieldElement(const FieldElement& other);
  FieldElement(FieldElement&& other) noexcept;
  FieldElement& operator=(const FieldElement& other);
  FieldElement& operator=(FieldElement&& other) noexcept;
  ~FieldElement();

  [[nodiscard]] const Field& field() const { return field_; }
  [[nodiscard]] bool is_zero() const;
  [[nodiscard]] bool is_rational() const;
  /// Throws std::domain_error unless it is rational.
  [[nodiscard]] Rational rational() const;
  /// The coefficients in t.
  [[nodiscard]] std::vector<Rational> coefficients() const;
  /// −1, 0 or 1 in the embedding of the field.
  [[nodiscard]] int sign() const;
  /// An interval around the number, as narrow as evaluation at the working precision gives.
  [[nodiscard]] BigInterval enclosure() const;
  /// A polynomial in t, as `parse_polynomial` reads it.
  [[nodiscard]] std::string text() const;

  friend FieldElement operator+(const FieldElement& a, const FieldElement& b);
  friend FieldElement operator-(const FieldElement& a, const FieldElement& b);
  friend FieldElement operator*(const FieldElement& a, const FieldElement& b);
  /// Throws std::domain_error if b is 0.
  friend FieldElement operator/(const FieldElement& a, const FieldElement& b);
  friend FieldElement operator-(const FieldElement& a);
  FieldElement& operator+=(const FieldElement& b) { return *this = *this + b; }
  FieldElement& operator-=(const FieldElement& b) { return *this = *this - b; }
  FieldElement& operator*=(const FieldElement& b) { return *this = *this * b; }

  friend bool operator==(const FieldElement& a, const FieldElement& b);
  /// An order of representations, for containers; it has nothing to do with size.
  friend bool precedes(const FieldElement& a, const FieldElement& b);

 private:
  explicit FieldElement(Field field);
  void reduce();

  Field field_;
  fmpq_poly_t value_;
};

}  // namespace delcert
