#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "proofs/formula/claim.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "support/progress.hpp"

namespace delcert {

inline constexpr double worthless_score = -1;

/// Draws the same choices with these limits. Nothing if they lead to no instance.
using LimitedDraw = std::function<std::optional<Instance>(const Limits&)>;

struct SearchResult {
  double score = worthless_score;
  LimitedDraw draw;  ///< of the best choices
  std::uint64_t evaluations = 0;
};

/// The score of one choice of numbers, `worthless_score` where it is of no use; not needed sharply where it is not
/// above `known`. Each call counts as one evaluation.
using DrawScore = std::function<double(const LimitedDraw& draw, double known)>;

/// Searches for the choices with the greatest score: random ones first, then, where the class has them, structured ones
/// (`InstanceClass::draw_structured`), then local searches from the best of both, a few changed choices at a time and
/// by a method without derivatives (Subplex). Half of them are left off after each round, so that the best gets most of
/// the evaluations. Every 20 000 evaluations add six starts, up to 48. The same for the same seed and stream. What
/// `score` and `progress` throw passes through. Nothing if all are worthless. Precondition: the claim outlives the
/// result.
[[nodiscard]] std::optional<SearchResult> directed_search(const Claim& claim, const Shape& shape,
                                                          const std::string& stream, const DrawScore& score,
                                                          std::uint64_t evaluations, std::uint64_t seed,
                                                          const Progress& progress);

}  // namespace delcert
