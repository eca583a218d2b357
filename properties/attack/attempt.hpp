#pragma once

#include <optional>
#include <span>
#include <vector>

#include "proofs/formula/claim.hpp"
#include "proofs/formula/decision.hpp"

namespace delcert {

/// Whether a conclusion holds on an instance, and how much of what it allows is taken up.
struct ConclusionOutcome {
  Verdict verdict = Verdict::undecided;
  std::optional<DoubleBounds> ratio;  ///< see `Evaluation::ratio`
};

/// What a claim says about one instance.
struct Attempt {
  /// All hypotheses hold; one certainly does not; undecided.
  Verdict hypotheses = Verdict::proved;
  /// Empty unless the hypotheses hold.
  std::vector<ConclusionOutcome> conclusions;
};

/// Decides all hypotheses, and if they hold, all conclusions. Ratios are sharp, up to 2⁻²⁰, where that is possible; or,
/// if `known` is not empty and has a number for each conclusion, where they may be above it: one that is certainly not
/// may be left out. Throws InputError where a
/// quantity is asked for what it cannot be asked (vertex 7 of a triangle).
[[nodiscard]] Attempt attempt(const Claim& claim, const Bindings& bindings, std::span<const double> known = {});

/// The formula whose ratio a search measures: the conclusion with its base, if it has one, taken off both sides.
[[nodiscard]] ExpressionPointer measured_formula(const Conclusion& conclusion);

/// The ratio of one conclusion, or of its excess over its base, sharp unless it certainly is not above `known`; nothing
/// unless all hypotheses are proved and it is defined. The conclusion is not decided, which next to equality takes
/// longest.
[[nodiscard]] std::optional<DoubleBounds> attempted_ratio(const Claim& claim, std::size_t conclusion,
                                                          const Bindings& bindings, double known);

}  // namespace delcert
