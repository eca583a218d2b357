#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "proofs/certificate/space_form_distortion.hpp"

namespace delcert {

/// Lines of `delcert certify`: distortion of charts as certified; the margin of the stability lemma; what the theorems
/// of the paper ask for or guarantee next to what there is. Figures are rounded so that they say no more than what is
/// known.
[[nodiscard]] std::string distortion_text(const SpaceFormDistortion& found);
/// The same as JSON; logarithms are to the base 2.
[[nodiscard]] nlohmann::ordered_json distortion_json(const SpaceFormDistortion& found);

/// Why `--mode theory` does not run: what Theorem 3 asks for next to what there is.
[[nodiscard]] std::string theory_refusal(const Ledger& ledger, const MeasuredNet& net);

}  // namespace delcert
