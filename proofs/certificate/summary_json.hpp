#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "proofs/certificate/reader.hpp"

namespace delcert {

/// What `delcert info --json` prints, as an object: `manifold`, `family`, `dimension`, `points`, `parameters`,
/// `levels_claimed`, `software`, `sha256`. All as the certificate says; nothing is verified.
[[nodiscard]] nlohmann::ordered_json summary_json(const CertificateSummary& certificate);

/// Its text, with escape sequences for all but ASCII: what a name holds may reach neither a terminal nor a parser.
[[nodiscard]] std::string ascii_text(const nlohmann::ordered_json& json, int indentation = -1);

}  // namespace delcert
