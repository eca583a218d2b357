#pragma once

#include <string>

#include "proofs/formula/claim.hpp"

namespace delcert {

/// The claim as the text of a claim file (docs/claim-format.md), with all on which an attack and its report depend and
/// nothing else: no title, no note, no twins, no steps. Equal texts are attacked alike. `parse_claim` reads it back.
/// Precondition: the claim is about a class of instances.
[[nodiscard]] std::string claim_text(const Claim& claim);

/// The text of the file that the claim was read from: of the library's, or of what is on the disk now. Throws
/// InputError if it cannot be read.
[[nodiscard]] std::string file_text_of(const Claim& claim);

}  // namespace delcert
