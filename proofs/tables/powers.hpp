#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// What a search found of a change at one place of a claim, in one shape (`delcert power`).
struct PowerOfPlace {
  std::string claim;
  std::string part;  ///< the conclusion, or the hypothesis, that was changed
  std::string dimension;
  std::string place;
  std::string kind;
  std::optional<Rational> scale;  ///< nothing: not refuted by scaling
  bool is_deletion_refuted = false;
  bool can_be_deleted = false;
  bool says_less = false;         ///< without it, on all instances
  std::uint64_t evaluations = 0;  ///< instances that were tried; 0 where it is not recorded
};

/// Reads what `delcert power --json` prints; entries without an instance are left out. Throws InputError if it is
/// something else.
[[nodiscard]] std::vector<PowerOfPlace> parse_powers(const std::string& json, const std::string& file);

/// For each dimension the scale that is nearest to 1, rounded away from it, or "no power":
/// "k=1: × 0.062, k=2: no power". Empty if nothing is known of the place.
[[nodiscard]] std::string power_by_dimension(const std::vector<PowerOfPlace>& powers, const std::string& claim,
                                             const std::string& part, const std::string& place,
                                             const std::string& kind);

/// The page docs/tables/power.md: a line for each place, with what is known for each dimension, and with how many
/// instances.
[[nodiscard]] std::string power_page(const std::vector<PowerOfPlace>& powers);

/// "× 0.062"; rounded away from 1, so that the witness refutes with it, too.
[[nodiscard]] std::string scale_text(const Rational& scale);

}  // namespace delcert
