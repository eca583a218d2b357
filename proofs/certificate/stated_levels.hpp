#pragma once

#include <vector>

#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/reader.hpp"

namespace delcert {

/// The levels of a certificate as it states them, in its order: each bound with its side and unit, all else as JSON of
/// its type; what no version of the format has under such a key is a string. Nothing is verified. Throws InputError,
/// naming the level and the key, for a bound that is no exact number.
[[nodiscard]] std::vector<ClaimedLevel> stated_levels(const CertificateSummary& certificate);

}  // namespace delcert
