#include "properties/attack/growth.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/formula/formula_error.hpp"
#include "proofs/formula/places.hpp"
#include "proofs/formula/substitution.hpp"
#include "proofs/formula/type_check.hpp"
#include "properties/attack/attempt.hpp"
#include "properties/attack/directed_search.hpp"
#include "properties/attack/exponent.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

ExpressionPointer comparison(const ExpressionPointer& left, Operation operation, const ExpressionPointer& right) {
  auto result = std::make_shared<Expression>();
  result->operation = operation;
  result->type = types::truth;
  result->children = {left, right};
  return result;
}

Rational last_value(const GrowthTarget& target) { return target.value * width_of_a_value(); }

/// The claim for instances on which the quantity has nearly the value. The bound from above is of a form that drawing
/// takes for a limit.
Claim narrowed(const GrowthTarget& target, const ExpressionPointer& quantity) {
  Claim result = target.claim;
  const auto add = [&](Operation operation, const Rational& value) {
    Hypothesis hypothesis;
    hypothesis.formula = comparison(quantity, operation, number_expression(value));
    result.hypotheses.push_back(std::move(hypothesis));
  };
  add(Operation::greater_equal, target.value);
  add(Operation::less_equal, last_value(target));
  return result;
}

/// Bounds from the filter.
std::optional<DoubleBounds> bounds_of(const Expression& term, Scene& scene) {
  const RoundingGuard guard;
  const auto value = Evaluation<Interval>(scene).number(term);
  if (!value) return std::nullopt;
  return DoubleBounds{value->lower(), value->upper()};
}

/// How far a quantity is from where it should be, as the absolute value of a logarithm; 0 where it is or may be there.
/// Nothing where it is not positive. Without error bounds.
std::optional<double> distance_from(const GrowthTarget& target, const Expression& quantity, Scene& scene) {
  const auto value = bounds_of(quantity, scene);
  if (!value || !(value->lower > 0)) return std::nullopt;
  const double least = approximate_double(target.value);
  const double greatest = approximate_double(last_value(target));
  if (value->upper < least) return std::log2(least / value->upper);
  if (value->lower > greatest) return std::log2(value->lower / greatest);
  return 0;
}

std::string stream_name(const GrowthTarget& target) {
  return "growth " + target.claim.name + " " + std::to_string(target.conclusion) + " " +
         std::to_string(target.shape.k) + " " + std::to_string(target.shape.m) + " " + target.quantity;
}

}  // namespace

const Rational& width_of_a_value() {
  static const Rational result = Rational(9) / Rational(8);
  return result;
}

ExpressionPointer quantity_in(const Claim& claim, const std::string& text) {
  Signature signature = instance_class(claim.instance).signature();
  for (const auto& [name, range] : claim.parameters) signature[name] = types::number;
  try {
    return type_checked(parse_formula(text), full_vocabulary(), signature, types::number);
  } catch (const FormulaError& error) {
    throw InputError("\"" + text + "\" is no quantity of " + claim.name + ": column " +
                     std::to_string(error.offset() + 1) + ": " + error.what());
  }
}

std::optional<GrowthPoint> worst_at(const GrowthTarget& target, std::uint64_t seed, const Progress& progress) {
  const ExpressionPointer quantity = quantity_in(target.claim, target.quantity);
  const Claim claim = narrowed(target, quantity);
  const HypothesisLimits limits(claim);
  const DrawScore score = [&](const LimitedDraw& draw, double known) {
    const auto instance = draw(limits);
    if (!instance) return worthless_score;
    Scene scene(instance->bindings);
    const auto distance = distance_from(target, *quantity, scene);
    if (!distance) return worthless_score;
    if (*distance > 0) return worthless_score * *distance / (1 + *distance);
    const auto ratio = attempted_ratio(claim, target.conclusion, instance->bindings, known);
    return ratio && std::isfinite(ratio->lower) ? ratio->lower : worthless_score;
  };
  const auto best =
      directed_search(claim, target.shape, stream_name(target), score, target.evaluations, seed, progress);
  if (!best || best->score < 0) return std::nullopt;
  const auto instance = best->draw(limits);
  auto worst = instance ? judged(claim, target.conclusion, instance->bindings) : std::nullopt;
  if (!worst) return std::nullopt;
  worst->evaluations = best->evaluations;
  Scene scene(worst->bindings);
  const auto value = bounds_of(*quantity, scene);
  if (!value) return std::nullopt;
  return GrowthPoint{*std::move(worst), *value};
}

std::optional<LineFit> line_through(const std::vector<std::pair<double, double>>& points) {
  const auto count = static_cast<double>(points.size());
  if (points.size() < 3) return std::nullopt;
  double mean_x = 0;
  double mean_y = 0;
  for (const auto& [x, y] : points) {
    mean_x += x / count;
    mean_y += y / count;
  }
  double spread = 0;
  double together = 0;
  for (const auto& [x, y] : points) {
    spread += (x - mean_x) * (x - mean_x);
    together += (x - mean_x) * (y - mean_y);
  }
  if (!(spread > 0)) return std::nullopt;
  LineFit result;
  result.slope = together / spread;
  double squares = 0;
  for (const auto& [x, y] : points) {
    const double off = y - mean_y - result.slope * (x - mean_x);
    squares += off * off;
    result.residual = std::max(result.residual, std::abs(off));
  }
  result.error = std::sqrt(squares / (count - 2) / spread);
  return result;
}

std::optional<BoundExponent> exponent_in_bound(const Claim& claim, std::size_t conclusion, const Expression& quantity,
                                               const Shape& shape) {
  const ExpressionPointer formula = without_definitions(claim.conclusions.at(conclusion).formula);
  const Bindings integers{{"k", static_cast<long>(shape.k)}, {"m", static_cast<long>(shape.m)}};
  BoundExponent result{Rational(0), true};
  for (const Place& place : places_in(*formula)) {
    if (place.kind != PlaceKind::bound) continue;
    const Expression* term = formula.get();
    for (const std::size_t child : place.path) term = term->children[child].get();
    const auto exponent = exponent_of(quantity, *term, integers);
    if (!exponent) return std::nullopt;
    result = {*exponent, place.stronger_if_smaller};
    if (*exponent != Rational(0)) break;
  }
  return result;
}

}  // namespace delcert
