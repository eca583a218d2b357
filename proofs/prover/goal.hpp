#pragma once

#include <string>
#include <vector>

#include "kernel/number/verdict.hpp"
#include "proofs/formula/step.hpp"
#include "proofs/prover/box.hpp"
#include "proofs/prover/rational_function.hpp"

namespace delcert {

/// left − right of a comparison is `constant` times powers of polynomials, where no divisor vanishes.
struct PolynomialForm {
  struct Power {
    std::size_t factor = 0;  ///< a number in `Goal::factors`
    long exponent = 1;       ///< negative for what is divided by
  };
  Rational constant;
  std::vector<Power> powers;
  std::vector<std::size_t> divisors;  ///< numbers in `Goal::factors`
};

/// A comparison in a goal: left − right is known by its polynomials, or by its enclosures.
struct Atom {
  Operation relation = Operation::less;
  ExpressionPointer left;
  ExpressionPointer right;
  bool is_about_definedness = false;  ///< says only that left has a value, written left = left
  std::optional<PolynomialForm> polynomial;
  std::size_t enclosure = 0;  ///< the number of left − right on the tape, if there is no polynomial
};

/// One connective of a goal.
struct GoalNode {
  enum class Kind : unsigned char { atom, negation, conjunction, disjunction };
  Kind kind = Kind::atom;
  std::size_t atom = 0;
  std::vector<std::size_t> children;
};

/// A statement for all parameters, made ready for the search: comparisons of polynomials and of enclosures, joined.
struct Goal {
  ExpressionPointer statement;
  std::vector<std::string> names;
  std::vector<StepRange> ranges;
  std::vector<bool> is_squared;  ///< the variable of the polynomials is the root of the parameter
  RingPointer ring;
  std::vector<Polynomial> factors;
  std::vector<Atom> atoms;
  std::vector<GoalNode> nodes;
  std::size_t root = 0;
  EnclosureTape tape{{}};

  /// "polynomial", "interval" or "mixed": what its comparisons are decided by.
  [[nodiscard]] std::string method() const;
  /// Kleene's value of the whole from those of the comparisons.
  [[nodiscard]] Verdict value(const std::vector<Verdict>& verdicts) const { return value(root, verdicts); }

 private:
  [[nodiscard]] Verdict value(std::size_t node, const std::vector<Verdict>& verdicts) const;
};

/// The statements that together say that the hypotheses imply the claim: one for each part of a conjunction, with the
/// greatest and least of several terms and absolute values on either side of a comparison resolved.
[[nodiscard]] std::vector<ExpressionPointer> goal_statements(const std::vector<ExpressionPointer>& hypotheses,
                                                             const ExpressionPointer& claim);

/// Precondition: the statement is about numbers and has no quantifiers and definitions.
[[nodiscard]] Goal make_goal(const ExpressionPointer& statement, const std::map<std::string, StepRange>& parameters);

/// The sign of a polynomial on all boxes, from its coefficients of Bernstein on each as a whole; unknown also if there
/// are too many of them.
[[nodiscard]] Sign sign_on(const std::vector<Box>& boxes, const Polynomial& polynomial);

/// What a comparison is, given the sign of left − right.
[[nodiscard]] Verdict verdict_of(Operation relation, Sign difference);

}  // namespace delcert
