#pragma once

#include <map>
#include <string>

#include "proofs/prover/prover.hpp"

namespace delcert {

/// Whether a step says something: whether parameters obey its hypotheses.
struct Vacuity {
  /// *Proved*: some goal of the step is about no parameters at all. *Refuted*: for each goal there are parameters in
  /// their ranges that obey the hypotheses and the premises of the goal, exactly.
  Verdict verdict = Verdict::undecided;
  std::map<std::string, Rational> point;  ///< such parameters, of the first goal, if refuted
  std::string premises;                   ///< what contradicts itself if proved, what is left open if undecided
};

/// Decides it as `prove` decides steps: hypotheses that imply what is false are contradictory, and a counterexample to
/// that is a point that obeys them. `p implies q` makes p a premise of q, so that a step whose p never holds is
/// vacuous.
[[nodiscard]] Vacuity vacuity_of(const Step& step, const SearchLimits& limits = {});

}  // namespace delcert
