#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kernel/formula/expression.hpp"
#include "kernel/formula/polynomial.hpp"

namespace delcert {

/// A quotient of two polynomials without a common factor; the denominator is not 0.
struct RationalFunction {
  Polynomial numerator;
  Polynomial denominator;
};

/// The quotient without common factors; the denominator is 1 if it is a number. Precondition: it is not 0.
[[nodiscard]] RationalFunction reduced(const Polynomial& numerator, const Polynomial& denominator);
[[nodiscard]] RationalFunction variable_function(const RingPointer& ring, std::size_t index);

// All throw std::length_error if what they are given is too large to be worked with.
[[nodiscard]] RationalFunction operator+(const RationalFunction& a, const RationalFunction& b);
[[nodiscard]] RationalFunction operator-(const RationalFunction& a, const RationalFunction& b);
[[nodiscard]] RationalFunction operator*(const RationalFunction& a, const RationalFunction& b);
/// Precondition: b is not 0.
[[nodiscard]] RationalFunction operator/(const RationalFunction& a, const RationalFunction& b);
/// Whether they are the same function, however it is written.
[[nodiscard]] bool operator==(const RationalFunction& a, const RationalFunction& b);

/// Whether it has few enough terms to be worked with.
[[nodiscard]] bool is_moderate(const RationalFunction& a);
/// Whether a power of a polynomial certainly has a moderate number of terms of a moderate degree.
[[nodiscard]] bool has_moderate_power(const Polynomial& base, unsigned long exponent);

/// What stands for |a|; none if nothing does.
using AbsoluteValue = std::function<std::optional<RationalFunction>(const RationalFunction& a)>;

/// A plain formula in these variables, in their order those of the ring. None if it is no rational function of moderate
/// size: it names another function, divides by what is 0, or is too large to be written out; or it has an absolute
/// value for which nothing stands.
[[nodiscard]] std::optional<RationalFunction> rational_function_of(const Expression& formula,
                                                                   const std::vector<std::string>& variables,
                                                                   const RingPointer& ring,
                                                                   const AbsoluteValue& absolute_value = nullptr);

/// p(f_0, f_1 …), where the denominators of the f do not vanish the same as that. Throws std::length_error if it is too
/// large to be written out. Precondition: as many f as p has variables, over one ring.
[[nodiscard]] RationalFunction composed(const Polynomial& p, const std::vector<RationalFunction>& f);
/// The same for a quotient; none if its denominator becomes 0 everywhere.
[[nodiscard]] std::optional<RationalFunction> composed(const RationalFunction& g,
                                                       const std::vector<RationalFunction>& f);

/// The exact value; none where the denominator is 0. Precondition: as many numbers as there are variables.
[[nodiscard]] std::optional<Rational> value_at(const RationalFunction& f, const std::vector<Rational>& x);

}  // namespace delcert
