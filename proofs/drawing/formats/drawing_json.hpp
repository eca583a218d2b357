#pragma once

#include <string>

#include "proofs/certificate/certificate_facts.hpp"
#include "proofs/drawing/drawing.hpp"

namespace delcert {

/// The drawing as one JSON object, "delcert-drawing" version 1 (docs/export.md). ASCII. `is_exact`: with the exact
/// texts of the points and the net.
[[nodiscard]] std::string drawing_json(const CertificateSummary& certificate, const Drawing& drawing,
                                       Verification verification, bool is_exact);

}  // namespace delcert
