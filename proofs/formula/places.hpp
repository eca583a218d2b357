#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kernel/formula/expression.hpp"

namespace delcert {

/// What stands at a place of a comparison.
enum class PlaceKind : unsigned char {
  bound,     ///< a whole side
  summand,   ///< one of several terms that are added
  constant,  ///< a number that is not simply a factor of a bound or of a summand
  factor,    ///< a factor of a product that is not a number
};

[[nodiscard]] const char* name_of(PlaceKind kind);

/// A term of a statement that can be scaled or deleted.
struct Place {
  PlaceKind kind = PlaceKind::bound;
  std::vector<std::size_t> path;  ///< the numbers of the children, from the root
  std::string text;
  /// Whether the statement says more when the term is smaller, as far as its form shows: all quantities are taken for
  /// positive, and exponents too unless they are negative numbers. Not for a soundness argument.
  bool stronger_if_smaller = false;
};

/// The places of all comparisons, in the order of the text, those in guards left out (what is left of `implies`, below
/// `not`, sets of quantifiers); in the arguments of functions, those of sqrt, min and max only. A side that is a bare
/// name or call has none, unless the other side is bare too: then the larger side is a place. Precondition:
/// type-checked, without definitions (`without_definitions`).
[[nodiscard]] std::vector<Place> places_in(const Expression& statement);

/// The statement with the term multiplied by a number.
[[nodiscard]] ExpressionPointer with_place_scaled(const ExpressionPointer& statement, const Place& place,
                                                  const Rational& factor);

/// The statement with 1 for a factor and 0 for any other term.
[[nodiscard]] ExpressionPointer without_place(const ExpressionPointer& statement, const Place& place);

/// The comparison of a place alone, under its quantifiers and guards: what stands next to it in conjunctions is left
/// out, so that the statement implies it. The path of the place leads to the same term in it.
struct FocusedStatement {
  ExpressionPointer formula;
  Place place;
};
[[nodiscard]] FocusedStatement focused(const ExpressionPointer& statement, const Place& place);

}  // namespace delcert
