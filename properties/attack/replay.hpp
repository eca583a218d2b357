#pragma once

#include <optional>
#include <string>

#include "proofs/formula/claim.hpp"
#include "proofs/formula/decision.hpp"
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
  /// Whether the claim that the witness names is now what it was then, if the text in the witness was decided; why not
  /// known, or what has changed, else empty.
  std::string remark = {};
};

/// Decides the claim whose text the witness carries, in whatever folder; or this one (a name or a file); or, of a
/// witness without a text, the claim that it names. Nothing of an attack enters. Throws InputError if there is no such
/// claim, or it is about another class of instances.
[[nodiscard]] Replay replayed(const Witness& witness, const std::string& claim = "");

}  // namespace delcert
