#include "properties/attack/attempt.hpp"

#include <mpfr.h>

#include "proofs/formula/substitution.hpp"

namespace delcert {

namespace {

DoubleBounds double_bounds(const BigInterval& x) {
  return {mpfr_get_d(&x.mpfi()->left, MPFR_RNDD), mpfr_get_d(&x.mpfi()->right, MPFR_RNDU)};
}

/// Not where the bounds are infinite.
bool is_sharp(const DoubleBounds& ratio) {
  constexpr double sharp_enough = 0x1p-20;
  return ratio.upper - ratio.lower <= sharp_enough * ratio.upper;
}

/// The ratio from the filter; from 128 bits, which mostly are there already where the filter does not tell; or from
/// more: until it is sharp, or certainly not above a known one.
std::optional<DoubleBounds> ratio_as_sharp_as_needed(const Expression& statement, Scene& scene, const double* known) {
  std::optional<DoubleBounds> ratio = ratio_bounds(statement, scene, false);
  const auto is_enough = [&] { return ratio && (is_sharp(*ratio) || (known != nullptr && ratio->upper <= *known)); };
  if (is_enough()) return ratio;
  {
    constexpr unsigned bits = 128;
    const BigInterval::Precision precision(PrecisionBits{bits});
    const auto sharper = Evaluation<BigInterval>(scene).ratio(statement);
    if (sharper) ratio = double_bounds(*sharper);
  }
  if (is_enough()) return ratio;
  const auto sharpest = ratio_bounds(statement, scene, true);
  return sharpest ? sharpest : ratio;
}

}  // namespace

ExpressionPointer measured_formula(const Conclusion& conclusion) {
  return conclusion.base ? less_base(conclusion.formula, conclusion.base->formula) : conclusion.formula;
}

Attempt attempt(const Claim& claim, const Bindings& bindings, std::span<const double> known) {
  Scene scene(bindings);
  Attempt result;
  for (const Hypothesis& hypothesis : claim.hypotheses) {
    result.hypotheses = conjunction(result.hypotheses, decide_statement(*hypothesis.formula, scene));
    if (is_refuted(result.hypotheses)) return result;
  }
  if (!is_proved(result.hypotheses)) return result;
  for (std::size_t at = 0; at < claim.conclusions.size(); ++at) {
    const Expression& statement = *claim.conclusions[at].formula;
    ConclusionOutcome outcome;
    outcome.verdict = decide_statement(statement, scene);
    outcome.ratio = ratio_as_sharp_as_needed(statement, scene, known.empty() ? nullptr : &known[at]);
    result.conclusions.push_back(outcome);
  }
  return result;
}

std::optional<DoubleBounds> attempted_ratio(const Claim& claim, std::size_t conclusion, const Bindings& bindings,
                                            double known) {
  Scene scene(bindings);
  for (const Hypothesis& hypothesis : claim.hypotheses) {
    if (!is_proved(decide_statement(*hypothesis.formula, scene))) return std::nullopt;
  }
  return ratio_as_sharp_as_needed(*measured_formula(claim.conclusions.at(conclusion)), scene, &known);
}

}  // namespace delcert
