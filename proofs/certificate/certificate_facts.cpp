#include "proofs/certificate/certificate_facts.hpp"

#include <fmt/format.h>

#include "delcert_version.hpp"
#include "proofs/certificate/summary_json.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"

namespace delcert {

void require_seal(const CertificateSummary& certificate) {
  if (certificate.seal == certificate.sealed_bytes) return;
  throw InputError("the seal is wrong: the content has the SHA-256 " + certificate.sealed_bytes +
                   ", and not the one at its end");
}

std::string origin_text(const CertificateSummary& certificate, Verification verification) {
  const std::string_view verdict = verification == Verification::verified   ? "verified by delcert-check"
                                   : verification == Verification::rejected ? "not verified: rejected by delcert-check"
                                                                            : "not verified";
  return fmt::format("delcert {}: manifold {}, certificate sha256 {} ({})", version,
                     ascii_text(shortened(certificate.manifold.name)), certificate.sealed_bytes, verdict);
}

}  // namespace delcert
