#pragma once

#include <optional>
#include <vector>

#include "kernel/formula/polynomial.hpp"

namespace delcert {

/// weight · base² · Π constraints, with a weight above 0.
struct SquareTerm {
  Rational weight;
  Polynomial base;
  std::vector<std::size_t> constraints;  ///< numbers of constraints, each at most once
};

/// Whether the polynomial is the sum of the terms, exactly, and every weight is above 0: where no constraint is
/// negative, the polynomial is not, either.
[[nodiscard]] bool is_sum(const Polynomial& polynomial, const std::vector<Polynomial>& constraints,
                          const std::vector<SquareTerm>& terms);

/// Terms of which the polynomial is the sum, if some are found: Gram matrices of squares, and of squares times one or
/// two constraints, near the centre of all that there are, rounded to rational numbers. Where every sum of squares
/// vanishes in a place, as it has to where the polynomial does, the squares are restricted to what vanishes there. What
/// is returned has been checked by `is_sum`.
[[nodiscard]] std::optional<std::vector<SquareTerm>> sum_of_squares(const Polynomial& polynomial,
                                                                    const std::vector<Polynomial>& constraints);

/// The same for a polynomial that is to be above 0: one of the terms is a constant.
[[nodiscard]] std::optional<std::vector<SquareTerm>> positive_sum_of_squares(
    const Polynomial& polynomial, const std::vector<Polynomial>& constraints);

}  // namespace delcert
