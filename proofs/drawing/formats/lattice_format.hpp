#pragma once

#include <string>

#include "proofs/drawing/formats/export_format.hpp"

namespace delcert {

/// The triangulation of a flat torus as a list of integers, exactly, for `delcert-verified` (docs/verified.md): the
/// least common denominator of the points, the Gram matrix without denominators, the points times that denominator,
/// and for each simplex its labels with their lattice vectors.
/// Throws InputError where the certificate is not as its format says.
[[nodiscard]] std::string lattice_text(const ExportContent& content);

/// Throws InputError unless the certificate is one of a flat torus.
void require_lattice(const CertificateSummary& certificate);

}  // namespace delcert
