#pragma once

#include <string>

#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/reader.hpp"

namespace delcert {

/// What a certificate claims as a tabular of LaTeX's booktabs, at most 345 pt wide: each margin exactly and as a
/// decimal that is rounded to its safe side, lengths also in units of the sampling radius ε; the number of points, the
/// SHA-256 in groups between which lines can be broken, and \cite of what `delcert cite` prints. Throws InputError
/// where the seal is wrong, and for a margin that is no exact number.
[[nodiscard]] std::string certificate_latex(const CertificateSummary& certificate);

/// A bound as a decimal of four digits: of a lower bound not above it, of an upper bound not below it.
[[nodiscard]] std::string safe_decimal(const Rational& x, Margin::Side side);
/// In units of ε or ε²; empty for what has no unit. Precondition: ε > 0.
[[nodiscard]] std::string safe_decimal_in_radii(const Margin& margin, const Rational& sampling_radius);

}  // namespace delcert
