#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kernel/manifold/quotient/field_matrix.hpp"
#include "kernel/manifold/quotient/polynomial_text.hpp"
#include "support/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {

/// ℚ(√5), t the golden ratio.
inline FieldElement::Field golden_field() {
  return std::make_shared<const NumberField>(std::vector<Rational>{Rational(-1), Rational(-1), Rational(1)},
                                             Rational(1), Rational(2));
}

inline FieldElement element(const FieldElement::Field& field, const std::string& text) {
  return {field, parse_polynomial(text)};
}

/// A matrix of polynomials in t.
inline FieldMatrix matrix(const FieldElement::Field& field, const std::vector<std::vector<std::string>>& rows) {
  FieldMatrix result(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < rows.size(); ++column) {
      const auto coefficients = parse_polynomial(rows[row][column]);
      result(row, column) = field ? FieldElement(field, coefficients) : FieldElement(coefficients.front());
    }
  }
  return result;
}

}  // namespace delcert::test
