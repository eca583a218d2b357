#include "properties/attack/replay.hpp"

#include "properties/attack/attempt.hpp"
#include "properties/attack/twins.hpp"

namespace delcert {

Replay replayed(const Witness& witness, const std::string& claim) {
  Replay replay;
  replay.claim = claim_of(witness, claim);
  const Attempt result = attempt(replay.claim, witness.bindings);
  replay.hypotheses = result.hypotheses;
  for (std::size_t at = 0; at < result.conclusions.size(); ++at) {
    const Conclusion& conclusion = replay.claim.conclusions[at];
    if (conclusion.name != witness.conclusion) continue;
    const ConclusionOutcome& outcome = result.conclusions[at];
    replay.conclusion = Replay::Outcome{conclusion.text, outcome.verdict, outcome.ratio};
    if (outcome.ratio) break;
    Scene scene(witness.bindings);
    replay.conclusion->ratio = ratio_bounds(*conclusion.formula, scene, true);
    break;
  }
  return replay;
}

}  // namespace delcert
