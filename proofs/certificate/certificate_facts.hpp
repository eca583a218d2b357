#pragma once

#include <optional>

#include "proofs/certificate/reader.hpp"

namespace delcert {

/// Whether the checker was asked about a certificate, and what it said.
enum class Verification : unsigned char { not_asked, verified, rejected };

/// Throws InputError unless the seal is the SHA-256 of the bytes that it is of.
void require_seal(const CertificateSummary& certificate);

/// For comments in files, on one line, ASCII: the program, the name, the SHA-256 of the certificate, and "not verified"
/// where the checker was not asked, or refused.
[[nodiscard]] std::string origin_text(const CertificateSummary& certificate, Verification verification);

}  // namespace delcert
