#pragma once

#include <cstddef>
#include <istream>
#include <map>
#include <set>
#include <string>

#include "proofs/replay/stated_step.hpp"

namespace delcert::replay {

/// What has been gone through in a log.
struct Totals {
  std::size_t steps = 0;
  std::size_t goals = 0;
  std::size_t leaves = 0;
  std::map<std::string, std::set<std::string>> proved;  ///< by claim the names of its steps
};

/// Checks a log of proofs (docs/prover.md, "The log"). Each step has to be one of the claims, with the parameters, the
/// hypotheses and the statement that its file states. Everything else is derived again from these: the goals, the
/// polynomials of their comparisons, the boxes of the trees and the signs on their leaves; the log only says where to
/// cut and into which factors polynomials fall apart. Throws Rejected, saying what is wrong with which step, and
/// Malformed if it is not a log.
Totals replay(std::istream& log, const StatedClaims& claims);

/// The second half alone: whether the log proves what it says itself, whoever states that.
Totals replay_as_logged(std::istream& log);

}  // namespace delcert::replay
