#pragma once

#include <functional>
#include <vector>

#include "proofs/prover/goal.hpp"

namespace delcert {

/// How much work a search may do. Counted in boxes, so that the result is the same everywhere.
struct SearchLimits {
  std::size_t boxes = 20000;
  std::size_t coefficients = 100000;  ///< of one polynomial
  std::size_t left = 8;               ///< boxes that remain undecided before the search gives up
  std::size_t cuts_of_a_side = 40;
};

/// A box of the search: cut in two, or proved as a whole.
struct ProofNode {
  std::optional<BoxCut> cut;  ///< nothing for a leaf
  std::size_t lower = 0;      ///< numbers of the parts in the list of nodes
  std::size_t upper = 0;
  bool is_exact = false;  ///< a leaf of one point, decided by the exact evaluation
};

struct SearchResult {
  Verdict verdict = Verdict::undecided;
  std::size_t boxes = 0;
  /// Of `boxes_of` in their order: the numbers of the whole boxes in `nodes`. Complete if proved.
  std::vector<std::size_t> roots;
  std::vector<ProofNode> nodes;
  std::vector<Box> left;                 ///< where it is undecided; at most `SearchLimits::left` of them
  std::vector<Rational> counterexample;  ///< if refuted; in the order of the parameters
};

/// What the goal is at a point of its parameters, exactly.
using DecideAt = std::function<Verdict(const std::vector<Rational>&)>;

/// Decides a goal for all parameters by branch and bound: a box is proved by signs of Bernstein coefficients and of
/// enclosures, or it is cut in two. *Refuted* rests on `decide_at` alone, which has to refute the goal at a point.
[[nodiscard]] SearchResult search(Goal& goal, const DecideAt& decide_at, const SearchLimits& limits);

/// The precision of enclosures.
inline constexpr PrecisionBits enclosure_precision{128U};

}  // namespace delcert
