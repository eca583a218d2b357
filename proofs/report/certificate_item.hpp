#pragma once

#include <optional>
#include <string>

#include "proofs/certificate/reader.hpp"
#include "proofs/report/page.hpp"

namespace delcert {

/// What the separate checker said of a certificate.
struct CheckRecord {
  std::string checker;            ///< "delcert-check 0.2.0"
  std::string date;               ///< "2026-11-23", of the check, in UTC
  nlohmann::ordered_json result;  ///< the object that `delcert-check --json` printed
};

/// A file whose certificate is shown.
struct ShownFile {
  std::string name;    ///< without folders
  std::string sha256;  ///< of its bytes as they are
};

/// A certificate for a page: its header, what the checker said, if it was asked, and a drawing with measures in as much
/// detail as `PageBudget` allows. Where something is left out, and where nothing can be drawn, a note on the page says
/// so. Does not throw for what cannot be drawn.
[[nodiscard]] PageItem certificate_item(const CertificateSummary& certificate, const ShownFile& file,
                                        const std::optional<CheckRecord>& check);

}  // namespace delcert
