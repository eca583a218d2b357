#include "properties/attack/tighten.hpp"

#include <cmath>
#include <string>

#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_variants.hpp"
#include "properties/attack/directed_search.hpp"
#include "properties/attack/hypothesis_limits.hpp"

namespace delcert {

std::optional<Tightest> judged(const Claim& claim, std::size_t conclusion, const Bindings& bindings) {
  Scene scene(bindings);
  const Expression& statement = *claim.conclusions.at(conclusion).formula;
  const auto ratio = ratio_bounds(*measured_formula(claim.conclusions[conclusion]), scene, true);
  if (!ratio) return std::nullopt;
  Tightest result;
  result.ratio = *ratio;
  result.verdict = decide_statement(statement, scene);
  result.is_equality = is_proved(result.verdict) && ratio->upper >= 1 &&
                       is_refuted(decide_statement(*made_strict(claim.conclusions[conclusion].formula), scene));
  result.bindings = bindings;
  return result;
}

std::optional<Tightest> tighten(const Claim& claim, std::size_t conclusion, const Shape& shape,
                                std::uint64_t evaluations, std::uint64_t seed, const Progress& progress) {
  const HypothesisLimits limits(claim);
  // Worthless where the hypotheses do not hold. Sharp where it is above what is known.
  const DrawScore score = [&](const LimitedDraw& draw, double known) {
    const auto instance = draw(limits);
    if (!instance) return worthless_score;
    const auto ratio = attempted_ratio(claim, conclusion, instance->bindings, known);
    // What is certified counts: bounds that stay wide would attract the search otherwise.
    return ratio && std::isfinite(ratio->lower) ? ratio->lower : worthless_score;
  };
  const std::string stream = "tighten " + claim.name + " " + std::to_string(conclusion) + " " +
                             std::to_string(shape.k) + " " + std::to_string(shape.m);
  const auto best = directed_search(claim, shape, stream, score, evaluations, seed, progress);
  const auto instance = best ? best->draw(limits) : std::nullopt;
  auto result = instance ? judged(claim, conclusion, instance->bindings) : std::nullopt;
  if (result) result->evaluations = best->evaluations;
  return result;
}

}  // namespace delcert
