#pragma once

#include <string>
#include <vector>

#include "proofs/constants/ledger.hpp"

namespace delcert {

/// Parameters of several ledgers: each dimension with each separation and each perturbation.
struct Sweep {
  std::vector<Dimension> dimensions;
  std::vector<Rational> separations;
  /// Empty: for each separation the largest that is allowed.
  std::vector<Rational> perturbations;
  Rational radius_variation;
  Rational distortion;
  ParameterConstraints constraints = ParameterConstraints::printed;
};

/// Parameters without a ledger.
struct LeftOut {
  Dimension dimension;
  Rational separation;
  Rational perturbation;
  std::string reason;  ///< which parameter is out of its range, and the range
};

struct SweptLedgers {
  /// Ordered by dimension, separation, perturbation, as these are listed.
  std::vector<Ledger> ledgers;
  /// Combinations outside of the ranges of constants_for, though each of their values is in some ledger.
  std::vector<LeftOut> left_out;
};

/// The ledgers of all combinations. Throws InputError as constants_for does if there is a value that no ledger has: it
/// is out of range whatever it is combined with. Precondition: dimensions and separations are not empty.
[[nodiscard]] SweptLedgers ledgers_of(const Sweep& sweep);

}  // namespace delcert
