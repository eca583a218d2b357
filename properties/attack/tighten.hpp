#pragma once

#include <cstdint>
#include <optional>

#include "proofs/formula/claim.hpp"
#include "proofs/formula/decision.hpp"
#include "properties/instances/instance_class.hpp"
#include "support/progress.hpp"

namespace delcert {

/// The instance with the largest ratio of a conclusion, or of its excess over its base, that a search has found.
struct Tightest {
  DoubleBounds ratio;                    ///< certified, from 256 bits
  bool is_equality = false;              ///< the conclusion holds on it with equality, decided exactly
  Verdict verdict = Verdict::undecided;  ///< of the conclusion on it
  Bindings bindings;
  std::uint64_t evaluations = 0;
};

/// What a conclusion says of one instance; `evaluations` is 0. Nothing if the ratio is not defined.
[[nodiscard]] std::optional<Tightest> judged(const Claim& claim, std::size_t conclusion, const Bindings& bindings);

/// Searches for the instance of this shape with the largest ratio of one conclusion among those on which the hypotheses
/// hold: random choices first, then a local search without derivatives (Subplex) from the best of them, several times.
/// Heuristics choose what to try; the ratio of what is returned is certified. The same for the same seed.
/// Nothing if no instance was found on which the hypotheses hold and the ratio is defined.
[[nodiscard]] std::optional<Tightest> tighten(const Claim& claim, std::size_t conclusion, const Shape& shape,
                                              std::uint64_t evaluations, std::uint64_t seed, const Progress& progress);

}  // namespace delcert
