#pragma once

#include <flint/fmpq_mpoly.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "proofs/checker/arithmetic/formula_map.hpp"
#include "proofs/checker/arithmetic/vector.hpp"

namespace delcert::checker {

/// A polynomial in m <= 3 variables with rational coefficients (FLINT's fmpq_mpoly). Operations on two: the same m.
/// FLINT is called with rounding to nearest; what is too large for this reader throws Undecided.
class Polynomial {
 public:
  Polynomial(std::size_t m, const Rational& constant);
  static Polynomial variable(std::size_t m, std::size_t k);
  Polynomial(const Polynomial& other);
  Polynomial(Polynomial&& other) noexcept;
  Polynomial& operator=(Polynomial other) noexcept;
  ~Polynomial();

  std::size_t variable_count() const { return m_; }
  bool is_zero() const;
  bool is_constant() const;
  Rational at(const Vector<Rational>& x) const;
  /// In the variables x0, x1 …, as formulas are written.
  std::string text() const;

  friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend bool operator==(const Polynomial& a, const Polynomial& b);
  friend Polynomial common_divisor(const Polynomial& a, const Polynomial& b);
  /// Precondition: b divides a.
  friend Polynomial quotient(const Polynomial& a, const Polynomial& b);

 private:
  std::size_t size() const;
  std::size_t m_;
  fmpq_mpoly_t value_;
};

/// A quotient in lowest terms.
struct RationalFunction {
  /// Precondition: the denominator is not 0.
  RationalFunction(const Polynomial& numerator, const Polynomial& denominator);
  explicit RationalFunction(const Polynomial& p) : numerator(p), denominator(p.variable_count(), Rational(1)) {}

  Polynomial numerator, denominator;

  /// N D: where D does not vanish it has the sign of N/D, and vanishes where N does.
  Polynomial sign() const { return numerator * denominator; }
  friend bool operator==(const RationalFunction& a, const RationalFunction& b) {
    return a.numerator * b.denominator == b.numerator * a.denominator;
  }
};
using RationalMap = std::vector<RationalFunction>;

/// (x0, x1 …).
RationalMap identity_map(std::size_t m);
/// What stands for the absolute value that is this step of a map.
using AbsoluteValue = std::function<RationalFunction(std::size_t step, const RationalFunction& of)>;
/// f after x; none if something is divided by what is 0 everywhere. Precondition: f has no root and no transcendental
/// function, and no absolute value unless something stands for it.
std::optional<RationalMap> composed(const FormulaMap& f, const RationalMap& x, const AbsoluteValue& absolute = {});
/// Whether it has neither; absolute values count if there may be none.
bool is_rational(const FormulaMap& f, bool folds = false);
/// The polynomials, or the functions, as formulas, for enclosures.
FormulaMap formulas_of(std::size_t m, const std::vector<Polynomial>& polynomials);
FormulaMap formulas_of(std::size_t m, const RationalMap& map);

}  // namespace delcert::checker
