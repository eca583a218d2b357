#pragma once

#include <optional>

#include "proofs/formula/evaluation.hpp"

// What a formula is on an instance, from as many rungs as that takes.

namespace delcert {

/// Decides a statement on an instance: intervals, 128 bits, surds (counted as the rational rung), 256 … 4096 bits,
/// algebraic numbers, until a rung is sure.
[[nodiscard]] Verdict decide_statement(const Expression& statement, Scene& scene);

/// Bounds of a real number. Infinite where unbounded.
struct DoubleBounds {
  double lower = 0;
  double upper = 0;
};

/// Bounds of the ratio of a statement (see `Evaluation::ratio`), from the filter; `sharp`: from 256 bits.
[[nodiscard]] std::optional<DoubleBounds> ratio_bounds(const Expression& statement, Scene& scene, bool sharp);

/// The value of a term if it is rational, decided exactly; nothing if it is irrational, undefined or too large.
[[nodiscard]] std::optional<Rational> exact_value(const Expression& term, Scene& scene);

/// A rational lower bound of a term within 2^−bits of it, relatively; nothing if the term is undefined or cannot be
/// enclosed so well.
[[nodiscard]] std::optional<Rational> lower_bound(const Expression& term, Scene& scene, unsigned bits);

}  // namespace delcert
