#include "properties/attack/hypothesis_limits.hpp"

#include <algorithm>

#include "proofs/formula/decision.hpp"
#include "proofs/formula/evaluation.hpp"
#include "proofs/formula/type_check.hpp"

namespace delcert {

namespace {

constexpr long fine = -60;
constexpr unsigned enough_bits = 30;

/// A number of a range without one end or both: an end that belongs to it, or one at a distance of 2⁻²⁰ to 2²⁰ from the
/// end that there is, from 0 if there is none.
Rational draw_unbounded(const ParameterRange& range, Choices& choices) {
  const double kind = choices.unit();
  const Rational size = Rational(1) + choices.fraction(16);
  const bool is_negative = range.lower ? false : range.upper ? true : choices.happens(0.5);
  const Rational end = range.lower ? *range.lower : range.upper ? *range.upper : Rational(0);
  const bool has_end = range.has_lower || range.has_upper || (!range.lower && !range.upper);
  if (kind < 0.15 && has_end) return end;
  constexpr long far = 20;
  const Rational distance =
      size * Rational::power_of_two(kind < 0.6 ? choices.between(-2, 2) : choices.between(-far, far));
  return is_negative ? end - distance : end + distance;
}

/// A number of the range: an end that belongs to it, any number, or one near the lower end.
Rational draw_parameter(const ParameterRange& range, Choices& choices) {
  if (!range.lower || !range.upper) return draw_unbounded(range, choices);
  const Rational& lower = *range.lower;
  const Rational& upper = *range.upper;
  const Rational width = upper - lower;
  const double kind = choices.unit();
  const Rational where = choices.fraction(16);
  if (kind < 0.25 && range.has_upper) return upper;
  if (kind < 0.35 && range.has_lower) return lower;
  // Neither 0 nor 1, so that open ends are safe.
  const Rational inside = (where + Rational::power_of_two(-17));
  if (kind < 0.75) return lower + width * inside;
  return lower + width * inside * Rational::power_of_two(-choices.between(1, 40));
}

/// A lower bound of the term, within 2⁻³⁰ of it.
std::optional<Rational> quick_lower_bound(const Expression& term, Scene& scene) {
  {
    const RoundingGuard guard;
    const auto value = Evaluation<Interval>(scene).number(term);
    if (value && value->lower() > 0 && value->upper() - value->lower() <= 0x1p-30 * value->lower()) {
      return Rational::exactly(value->lower());
    }
  }
  return lower_bound(term, scene, enough_bits);
}

}  // namespace

HypothesisLimits::HypothesisLimits(const Claim& claim) : claim_(claim) {
  for (const Hypothesis& hypothesis : claim.hypotheses) collect(hypothesis.formula);
}

std::vector<ExpressionPointer> HypothesisLimits::constraints() const {
  std::vector<ExpressionPointer> result;
  for (const Hypothesis& hypothesis : claim_.hypotheses) {
    if (hypothesis.is_constraint) result.push_back(hypothesis.formula);
  }
  return result;
}

void HypothesisLimits::collect(const ExpressionPointer& statement) {
  if (statement->operation == Operation::conjunction) {
    for (const auto& part : statement->children) collect(part);
    return;
  }
  const bool turned = statement->operation == Operation::greater || statement->operation == Operation::greater_equal;
  if (!turned && statement->operation != Operation::less && statement->operation != Operation::less_equal) return;
  const auto& name = statement->children[turned ? 1 : 0];
  const auto& term = statement->children[turned ? 0 : 1];
  if (name->operation != Operation::name) return;
  const bool is_strict = statement->operation == Operation::less || statement->operation == Operation::greater;
  limits_.push_back({name->text, term, is_strict, free_names(*term)});
}

std::optional<Rational> HypothesisLimits::most(const std::string& name, const Bindings& bound, bool exact) const {
  std::optional<Rational> result;
  Scene scene(bound);
  for (const Limit& limit : limits_) {
    const bool known = std::all_of(limit.needs.begin(), limit.needs.end(),
                                   [&](const std::string& need) { return bound.contains(need); });
    if (limit.name != name || !known) continue;
    std::optional<Rational> here = exact ? exact_value(*limit.term, scene) : std::nullopt;
    if (!here) here = quick_lower_bound(*limit.term, scene);
    if (!here) here = Rational(0);
    if (limit.is_strict) *here -= absolute(*here) * Rational::power_of_two(fine);
    result = result ? minimum(*result, *here) : *here;
  }
  return result;
}

namespace {

Bindings draw_parameters(const Claim& claim, Choices& choices) {
  Bindings given;
  for (const auto& [name, range] : claim.parameters) given[name] = draw_parameter(range, choices);
  return given;
}

}  // namespace

std::optional<Instance> draw_instance(const Claim& claim, const Limits& limits, const Shape& shape, Choices& choices) {
  const Bindings given = draw_parameters(claim, choices);
  return instance_class(claim.instance).draw(shape, given, limits, choices);
}

std::optional<Instance> draw_structured_instance(const Claim& claim, const Limits& limits, const Shape& shape,
                                                 Choices& choices) {
  const Bindings given = draw_parameters(claim, choices);
  return instance_class(claim.instance).draw_structured(shape, given, limits, choices);
}

}  // namespace delcert
