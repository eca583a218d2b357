#pragma once

#include <string>

#include "proofs/drawing/formats/export_format.hpp"

namespace delcert {

/// How a certificate is to be exported. What is about coordinates is not asked of formats without them, and the other
/// way round.
struct ExportRequest {
  const ExportFormat* format = nullptr;
  DrawingOptions drawing;
  bool is_exact = false;
  bool simplify = false;
  Verification verification = Verification::not_asked;
};

struct ExportedText {
  std::string text;     ///< the bytes of the file
  std::string summary;  ///< "244 vertices, 5 simplices of dimension 3, …", for people
};

/// Throws InputError where the seal is wrong, where the certificate is not as its format says, and for what the format
/// cannot hold; Rejection where simplifying has changed the homology.
[[nodiscard]] ExportedText exported(const CertificateSummary& certificate, const ExportRequest& request);

}  // namespace delcert
