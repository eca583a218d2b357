#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proofs/formula/claim.hpp"
#include "properties/attack/tighten.hpp"

namespace delcert {

/// A search for the worst ratio of a conclusion among the instances on which a quantity has nearly a given value.
struct GrowthTarget {
  Claim claim;
  std::size_t conclusion = 0;
  Shape shape;
  std::string quantity;  ///< a formula about the names of the class and the claim's parameters
  Rational value;        ///< above 0
  std::uint64_t evaluations = 0;
};

/// What was found there.
struct GrowthPoint {
  Tightest worst;         ///< certified, as what `tighten` returns
  DoubleBounds quantity;  ///< on that instance
};

/// A quantity counts as nearly v from v to so many times v.
[[nodiscard]] const Rational& width_of_a_value();

/// The quantity as a formula. Throws InputError, saying why, if it is none about this claim or not a number.
[[nodiscard]] ExpressionPointer quantity_in(const Claim& claim, const std::string& text);

/// Searches for the instance with the largest ratio among those on which the hypotheses hold and the quantity is from v
/// to `width_of_a_value()` times v, all decided exactly for what is returned. An instance with another value is the
/// better the nearer it is. The same for the same seed. Nothing if none was found.
[[nodiscard]] std::optional<GrowthPoint> worst_at(const GrowthTarget& target, std::uint64_t seed,
                                                  const Progress& progress);

/// A straight line through points by least squares. Without error bounds.
struct LineFit {
  double slope = 0;
  double error = 0;     ///< the standard error of the slope, from the residuals
  double residual = 0;  ///< the largest distance of a point from the line, along the second axis
};

/// Nothing for fewer than three points, and where all have the same first coordinate.
[[nodiscard]] std::optional<LineFit> line_through(const std::vector<std::pair<double, double>>& points);

/// The exponent of a quantity in the bound of a conclusion, where the bound is a product of powers, and whether it is a
/// bound from above. Where a conclusion has several comparisons: of the first whose bound contains the quantity, 0 if
/// none does. Nothing where a bound depends on it in another way.
struct BoundExponent {
  Rational exponent;
  bool is_from_above = true;
};
[[nodiscard]] std::optional<BoundExponent> exponent_in_bound(const Claim& claim, std::size_t conclusion,
                                                             const Expression& quantity, const Shape& shape);

}  // namespace delcert
