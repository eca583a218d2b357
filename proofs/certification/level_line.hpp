#pragma once

#include <string>

#include "proofs/certificate/claims.hpp"

namespace delcert {

/// What is said of a level that is claimed; lengths in this unit, the sampling radius. Decimal figures are rounded in
/// the safe direction and marked by ≥ or ≤.
[[nodiscard]] std::string level_line(const Claims& claims, const std::string& level, const Rational& unit);

}  // namespace delcert
