#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/prover/goal.hpp"
#include "proofs/prover/sum_of_squares.hpp"

namespace delcert {

/// What is not negative wherever the hypotheses of a goal hold: x − a or b − x for an end of a variable's range, or the
/// difference of the sides of a comparison among the hypotheses, the side that is not smaller first.
struct SquaresConstraint {
  enum class Kind : unsigned char { lower_end, upper_end, comparison };
  Kind kind = Kind::lower_end;
  std::size_t number = 0;  ///< of the parameter, or of the atom
  bool is_turned = false;  ///< of an equation: right − left
  Polynomial polynomial;
};

/// The sign of one factor of a goal, where the hypotheses hold.
struct FactorSign {
  std::size_t factor = 0;
  Sign sign = Sign::unknown;  ///< positive, nonnegative, negative or nonpositive
  /// Of the factor, or of its negative if the sign is; empty where Bernstein's coefficients on the whole ranges show
  /// it.
  std::vector<SquareTerm> terms;
};

/// A goal h₁ implies (h₂ implies … c) with a comparison c of polynomials, proved without cutting any range in two: the
/// signs of the factors of c where all hypotheses hold.
struct SquaresProof {
  std::vector<SquaresConstraint> constraints;
  std::vector<FactorSign> signs;
};

/// Looks for one. Everything in it has been checked exactly.
[[nodiscard]] std::optional<SquaresProof> squares_proof(const Goal& goal);

}  // namespace delcert
