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
/// By dimension, "k=2", or "m=2" for a class without k: the greatest over the other dimension only. The greatest over
/// all would mostly be that of edges.
using WorstByDimension = std::map<std::string, WorstRatio>;
/// By "claim/conclusion".
using WorstRatios = std::map<std::string, WorstByDimension>;

/// "k=2"; "m=2" if k is 0.
[[nodiscard]] std::string dimension_name(int k, int m);

/// Reads what `delcert tighten --all --json` prints. Throws InputError if it is something else.
[[nodiscard]] WorstRatios parse_worst_ratios(const std::string& json, const std::string& file);

}  // namespace delcert
