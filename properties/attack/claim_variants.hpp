#pragma once

#include "proofs/formula/claim.hpp"

namespace delcert {

/// The claim with one conclusion only, replaced by its twin. Precondition: it has one.
[[nodiscard]] Claim twin_of_conclusion(const Claim& claim, std::size_t conclusion);
/// The claim without one of its hypotheses.
[[nodiscard]] Claim twin_of_hypothesis(const Claim& claim, std::size_t hypothesis);

/// The statement with < for every <= and > for every >=: refuted where the statement holds with equality.
[[nodiscard]] ExpressionPointer made_strict(const ExpressionPointer& statement);

}  // namespace delcert
