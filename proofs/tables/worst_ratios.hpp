#pragma once

#include <map>
#include <string>

#include "kernel/number/rational.hpp"

namespace delcert {

/// The worst instance of a conclusion that a search has found.
struct WorstRatio {
  Rational lower;            ///< of the smaller side to the larger one: a certified lower bound
  bool is_equality = false;  ///< both sides are the same number
};
/// By "claim/conclusion", over all shapes.
using WorstRatios = std::map<std::string, WorstRatio>;

/// Reads what `delcert tighten --all --json` prints. Throws InputError if it is something else.
[[nodiscard]] WorstRatios parse_worst_ratios(const std::string& json, const std::string& file);

}  // namespace delcert
