#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "proofs/formula/claim.hpp"
#include "proofs/formula/places.hpp"
#include "properties/instances/instance_class.hpp"
#include "support/progress.hpp"

namespace delcert {

/// A place of a claim that can be moved: of a conclusion, or the bound of a hypothesis `name <= term`.
struct PowerPlace {
  bool is_hypothesis = false;
  std::size_t part = 0;  ///< the number of the conclusion or hypothesis
  Place place;
};

/// The places of the conclusions, definitions such as hoop_bound written out; then the bounds of the hypotheses that
/// have no reason for the lack of a twin.
[[nodiscard]] std::vector<PowerPlace> power_places(const Claim& claim);

/// One place, one conclusion and one shape of a claim, with a number of instances to try.
struct PowerTarget {
  Claim claim;
  PowerPlace place;
  std::size_t conclusion = 0;  ///< the part of the place, if it is a place of a conclusion
  Shape shape;
  std::uint64_t evaluations = 0;
};

/// What a search found that an attack would notice of a change at a place.
struct Power {
  /// The scale nearest to 1 with which the conclusion was refuted: below 1 for a place whose conclusion says more when
  /// it is smaller, else above; 1 if the conclusion itself is refuted. Nothing: no power, as far as 2^±128.
  std::optional<Rational> scale;
  /// Whether the term can be deleted at all (`without_place`), and whether that was refuted.
  bool can_be_deleted = false;
  bool is_deletion_refuted = false;
  /// No instance was found on which the change makes the conclusion say more.
  bool is_weaker = false;
  /// The hypotheses held for some instance.
  bool has_instance = false;
  std::uint64_t evaluations = 0;
  /// With `scale`, or without it of the deletion: an instance that meets the hypotheses, changed ones included, and
  /// violates the conclusion, changed or not; decided exactly. `changed` is the formula that was changed.
  std::optional<Bindings> witness;
  std::string changed;
};

/// The powers of two that are divided into 64 equal steps: 1, 65/64 … 2, 65/32 … Precondition: 0 <= level <= 8192.
[[nodiscard]] Rational power_step(int level);
inline constexpr int last_power_step = 128 * 64;

/// Searches for the smallest change at a place that some instance refutes. Directed: the score of an instance is the
/// scale with which it begins to refute; for a hypothesis, the scale of the bound at which the conclusion fails on the
/// way from an instance with the bounded number (a distortion, say) near 0 to one where it is large, the other choices
/// being kept. That margin is continuous also where the conclusion is a bare truth, such as the equality of two stars.
/// Heuristics choose what to try; the witness is decided exactly, and that there is none means nothing else than
/// "no power with so many instances". The same for the same seed.
[[nodiscard]] Power power_of(const PowerTarget& target, std::uint64_t seed, const Progress& progress);

}  // namespace delcert
