#pragma once

#include <optional>
#include <string>

#include "proofs/formal/comparison_script.hpp"
#include "proofs/prover/squares_proof.hpp"

namespace delcert {

/// A proof by sums of squares for Coq, which only checks identities and that squares are not negative.
struct SquaresScript {
  std::string definitions;  ///< of tactics, before the lemma
  std::string facts;        ///< tactics that assert what the squares are multiplied by, from the hypotheses
  KnownSigns signs;
};

/// Nothing if a parameter is a square of its variable. Precondition: the parameters are those of the goal, in its
/// order.
[[nodiscard]] std::optional<SquaresScript> squares_script(const Goal& goal, const SquaresProof& proof,
                                                          const FormalParameters& parameters);

}  // namespace delcert
