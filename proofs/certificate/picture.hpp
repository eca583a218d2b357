#pragma once

#include <string>

#include "proofs/certificate/reader.hpp"

namespace delcert {

/// A drawing (SVG) of the complex of a two-dimensional certificate: one copy of every triangle, shaded by thickness,
/// for a torus with the outline of the unit cell. Made in doubles, for the eye. Throws InputError in other dimensions.
[[nodiscard]] std::string picture_svg(const CertificateSummary& certificate);

}  // namespace delcert
