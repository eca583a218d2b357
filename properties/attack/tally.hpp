#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "kernel/number/ladder.hpp"
#include "proofs/formula/decision.hpp"
#include "properties/attack/hypothesis_limits.hpp"

namespace delcert {

/// What became of one conclusion over many samples.
struct ConclusionTally {
  std::uint64_t held = 0;
  std::uint64_t violated = 0;
  std::uint64_t undecided = 0;
  std::optional<DoubleBounds> worst;  ///< the ratio with the greatest lower bound
  std::uint64_t worst_sample = 0;     ///< where it was found
  std::uint64_t first_violation = 0;  ///< meaningful if violated > 0
};

/// What became of many samples of one claim and shape. Adding tallies in the order of their samples gives the same
/// whatever the blocks were.
struct Tally {
  std::uint64_t samples = 0;
  std::uint64_t not_drawn = 0;  ///< the choices led to no instance
  std::uint64_t hypotheses_not_met = 0;
  std::uint64_t hypotheses_undecided = 0;
  std::array<std::uint64_t, 3> traits{};           ///< by `Trait`, of the instances on which the hypotheses hold
  std::map<std::string, std::uint64_t> manifolds;  ///< by where they live, of the same instances
  LadderStatistics rungs;                          ///< of all decisions
  std::vector<ConclusionTally> conclusions;

  [[nodiscard]] std::uint64_t met() const { return samples - not_drawn - hypotheses_not_met - hypotheses_undecided; }
  [[nodiscard]] std::uint64_t undecided() const;
  [[nodiscard]] bool is_refuted() const;
  /// The samples of `later` come after those of this one.
  void add(const Tally& later);
};

[[nodiscard]] nlohmann::ordered_json tally_json(const Tally& tally);
/// Throws nlohmann::json::exception or InputError for JSON that is not of a tally.
[[nodiscard]] Tally tally_from(const nlohmann::ordered_json& json);

/// Samples first … first + count − 1 of the attack on a claim with a seed: each depends on (seed, claim's name, shape,
/// number) only.
[[nodiscard]] Tally attack_block(const Claim& claim, const Shape& shape, std::uint64_t seed, std::uint64_t first,
                                 std::uint64_t count);

/// The instance of one sample; nothing if there was none.
[[nodiscard]] std::optional<Instance> sample_instance(const Claim& claim, const Shape& shape, std::uint64_t seed,
                                                      std::uint64_t number);

}  // namespace delcert
