#pragma once

#include <string>

#include "proofs/certificate/reader.hpp"

namespace delcert {

/// The complex as SVG, for `info --picture`. Throws InputError in dimensions other than 2. delcert, which draws
/// nothing, hands over to delcert-publish instead.
[[nodiscard]] std::string certificate_picture(const CertificateSummary& certificate);

}  // namespace delcert
