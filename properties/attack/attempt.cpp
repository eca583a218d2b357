#include "properties/attack/attempt.hpp"

#include <mpfr.h>

#include <cmath>

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

/// Whether the ratio of a comparison is certainly not above `known`, exactly, by square roots of rational numbers.
/// Asked where these have decided it: then they have its terms already, which 128 bits do not enclose well. Not for a
/// statement of several comparisons, of which those that surds cannot tell would be left out.
bool is_at_most(const Expression& statement, Scene& scene, double known) {
  if (!is_comparison(statement.operation)) return false;
  const auto ratio = Evaluation<Surd>(scene).ratio(statement);
  return ratio && is_proved(less_equal(*ratio, Surd(Rational::exactly(known))));
}

std::uint64_t decisions_by_surds() { return ladder_statistics().settled[static_cast<std::size_t>(Rung::rational)]; }

/// Decides the statement and measures it, if it may be above `known`.
ConclusionOutcome outcome_of(const Expression& statement, Scene& scene, const double* known) {
  ConclusionOutcome outcome;
  const std::uint64_t before = decisions_by_surds();
  outcome.verdict = decide_statement(statement, scene);
  const bool is_by_surds = decisions_by_surds() != before;
  if (is_by_surds && known != nullptr && std::isfinite(*known) && is_at_most(statement, scene, *known)) return outcome;
  outcome.ratio = ratio_as_sharp_as_needed(statement, scene, known);
  return outcome;
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
    result.conclusions.push_back(outcome_of(statement, scene, known.empty() ? nullptr : &known[at]));
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
