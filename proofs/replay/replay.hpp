#pragma once

#include <cstddef>
#include <istream>
#include <set>
#include <string>

#include "proofs/replay/stated_step.hpp"

namespace delcert::replay {

/// What has been gone through in a log.
struct Totals {
  std::size_t steps = 0;
  std::size_t goals = 0;
  std::size_t leaves = 0;
  std::string claim;             ///< the claim of the log
  std::set<std::string> proved;  ///< the names of its steps
  StatedClaim stated;            ///< what the steps were compared with: the claim's file, or the text in the log
  std::string file;              ///< the file's name when the log was written
  bool by_its_own_text = false;  ///< no file of the claim was known
};

/// What to compare a log with whose claim is none of those given.
enum class UnknownClaim {
  rejected,
  by_the_log  ///< with the text of the claim that the log carries
};

/// Checks a log of proofs (docs/prover.md, "The log"). Each step has to be one of the claims, with the parameters, the
/// hypotheses and the statement that its file states, and the log has to carry this file's text. Everything else is
/// derived again from these: the goals, the polynomials of their comparisons, the boxes of the trees and the signs on
/// their leaves; the log only says where to cut and into which factors polynomials fall apart. Throws Rejected, saying
/// what is wrong with which step on which line, and Malformed if it is not a log.
Totals replay(std::istream& log, const StatedClaims& claims, UnknownClaim unknown = UnknownClaim::rejected);

/// The second half alone: whether the log proves what it says itself, whoever states that.
Totals replay_as_logged(std::istream& log);

}  // namespace delcert::replay
