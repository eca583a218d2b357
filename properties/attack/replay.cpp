#include "properties/attack/replay.hpp"

#include "properties/attack/attempt.hpp"
#include "properties/attack/twins.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// What became of the claim since.
std::string remark_on(const Witness& witness) {
  try {
    if (statement_of(claim_of(witness)) == witness.text) return "";
    return witness.claim + " has changed since the witness was written; decided is the text in the witness";
  } catch (const InputError& error) {
    return witness.claim + " cannot be compared with the text in the witness, which is decided: " + error.what();
  }
}

}  // namespace

Replay replayed(const Witness& witness, const std::string& claim) {
  Replay replay;
  const bool by_its_text = claim.empty() && !witness.text.empty();
  replay.claim = by_its_text ? claim_in(witness) : claim_of(witness, claim);
  if (by_its_text) replay.remark = remark_on(witness);
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
