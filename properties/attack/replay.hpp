#pragma once

#include <optional>
#include <string>

#include "proofs/formula/claim.hpp"
#include "proofs/formula/evaluation.hpp"
#include "properties/attack/witness.hpp"

namespace delcert {

/// What a claim says about the instance of a witness, decided anew.
struct Replay {
  Claim claim;  ///< the twin, if the witness is of one
  Verdict hypotheses = Verdict::undecided;
  /// Of the conclusion that the witness names; nothing if the claim does not have it or the hypotheses do not hold.
  struct Outcome {
    std::string text;  ///< the formula
    Verdict verdict = Verdict::undecided;
    std::optional<DoubleBounds> ratio;  ///< see `Evaluation::ratio`
  };
  std::optional<Outcome> conclusion;
};

/// Decides the claim that the witness names, or this one (a name or a file). Nothing of an attack enters. Throws
/// InputError if there is no such claim, or it is about another class of instances.
[[nodiscard]] Replay replayed(const Witness& witness, const std::string& claim = "");

}  // namespace delcert
