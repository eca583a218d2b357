#pragma once

#include <map>
#include <string>
#include <vector>

#include "proofs/formula/step.hpp"
#include "proofs/prover/search.hpp"
#include "proofs/prover/squares_proof.hpp"

namespace delcert {

/// A goal of a step and what the search has made of it.
struct GoalOutcome {
  Goal goal;
  SearchResult result;
  std::optional<SquaresProof> squares;  ///< what proves the goal where the search has not
};

/// Whether a step holds for all its parameters.
struct StepOutcome {
  Verdict verdict = Verdict::undecided;
  std::string method;  ///< "polynomial", "squares", "interval" or "mixed"
  std::size_t boxes = 0;
  std::map<std::string, Rational> counterexample;  ///< of the parameters, if refuted
  std::vector<std::string> left;                   ///< what is left, if undecided: boxes, or the reason
  std::vector<GoalOutcome> goals;                  ///< all of them if proved, else those up to the one that is not
};

/// Decides a step for all parameters that its hypotheses allow, with the values given for its constants.
/// *Proved* rests on Bernstein coefficients and enclosures on boxes that cover all parameters, or on sums of squares;
/// *refuted* on a point at
/// which the hypotheses hold and the claim does not, decided exactly (docs/claim-format.md, "Values"). A term without
/// value where the hypotheses hold keeps a step from being proved. The result is the same everywhere.
[[nodiscard]] StepOutcome prove(const Step& step, const std::map<std::string, Rational>& constants,
                                const SearchLimits& limits = {});
[[nodiscard]] StepOutcome prove(const Step& step, const SearchLimits& limits = {});

/// What a step says at a point, exactly: proved also if a hypothesis fails there.
[[nodiscard]] Verdict decide_at(const Step& step, const std::map<std::string, Rational>& constants,
                                const std::map<std::string, Rational>& point);

}  // namespace delcert
