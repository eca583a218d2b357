#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proofs/certificate/certificate_facts.hpp"
#include "proofs/drawing/drawing.hpp"
#include "proofs/drawing/formats/label_complex.hpp"

namespace delcert {

/// What is written: a drawing of a certificate's complex, or the complex alone.
struct ExportContent {
  const CertificateSummary& certificate;
  Verification verification = Verification::not_asked;
  const Drawing* drawing = nullptr;       ///< of formats with coordinates
  const LabelComplex* complex = nullptr;  ///< of the others
  std::string note = {};                  ///< for comments: how the complex was simplified
  bool is_exact = false;                  ///< of formats that can hold exact coordinates

  /// For comments: `origin_text`, that coordinates are approximate if there are any, and the note.
  [[nodiscard]] std::string origin() const;
};

/// A format of files for other programs (docs/export.md).
struct ExportFormat {
  std::string_view name;
  std::string_view description;  ///< for a list of formats: a line
  bool has_coordinates;
  bool has_measures;
  /// Throws InputError, before anything is computed, for what the format cannot hold.
  void (*check)(const CertificateSummary&);
  /// The bytes of the file. Throws InputError for what the format cannot hold.
  std::string (*text)(const ExportContent&);
};

[[nodiscard]] const std::vector<ExportFormat>& export_formats();

/// Throws std::invalid_argument, with the one that was probably meant, where there is none of this name.
[[nodiscard]] const ExportFormat& export_format(std::string_view name);

}  // namespace delcert
