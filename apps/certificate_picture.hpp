#pragma once

#include <string>

namespace delcert {

struct CertificateSummary;

/// The complex as SVG, for `info --picture`. Throws InputError in dimensions other than 2. delcert, which draws
/// nothing, hands over to delcert-publish instead.
[[nodiscard]] std::string certificate_picture(const CertificateSummary& certificate);

}  // namespace delcert
