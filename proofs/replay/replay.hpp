#pragma once

#include <cstddef>
#include <istream>

namespace delcert::replay {

/// What has been gone through in a log.
struct Totals {
  std::size_t steps = 0;
  std::size_t goals = 0;
  std::size_t leaves = 0;
};

/// Checks a log of proofs (docs/prover.md, "The log"). Everything is derived again from the statements: the goals, the
/// polynomials of their comparisons, the boxes of the trees and the signs on their leaves; the log only says where to
/// cut and into which factors polynomials fall apart. Throws Rejected, saying what is wrong with which step, and
/// Malformed for what is no log.
Totals replay(std::istream& log);

}  // namespace delcert::replay
