#pragma once

#include <vector>

#include "proofs/formula/formula_reader.hpp"

namespace delcert {

/// The steps of a claim's file, its [[step]] tables (docs/claim-format.md). A step without a status has that of the
/// file. Throws InputError for anything that is not as the manual says.
[[nodiscard]] std::vector<Step> read_steps(const FormulaReader& reader, const toml::table& claim, ClaimStatus status,
                                           const Vocabulary& vocabulary);

}  // namespace delcert
