#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "kernel/simplex/vector.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/placed_complex.hpp"
#include "proofs/certificate/run_parameters.hpp"
#include "support/progress.hpp"

namespace delcert {

/// Everything that goes into a certificate, in any family. References are kept.
template <int m>
struct CertificateContent {
  using Numbers = std::function<std::vector<Rational>(Label)>;

  std::string manifold;  ///< the value of the key, as `manifold_object` makes it
  const RunParameters& parameters;
  const Rational& sampling_radius;
  const Claims& claims;
  std::size_t labels;
  Numbers net;     ///< m coordinates; of a submanifold those of the space around
  Numbers points;  ///< home coordinates
  PlacedComplex<m> complex;
  /// Written if level 0 is claimed.
  std::span<const LiftedSimplex<m>> net_simplices = {};
  /// Of the transitions, an upper bound: ξ₀ of the parameters.
  Rational distortion = Rational(0);
  /// Of a metric field the entries of the matrix of the chart of a label; of a submanifold all that a chart is made of.
  Numbers charts = {};
  /// Of labels, where they vary: ε_i. And ε₀ of the parameters.
  std::function<Rational(Label)> radii = {};
  Rational radius_variation = Rational(0);
};

/// What a certificate states before its long arrays: `,"software":{…},"manifold":{…},"parameters":{…},"levels":{…}`.
template <int m>
[[nodiscard]] std::string certificate_head(const CertificateContent<m>& content);

/// Writes a certificate as docs/certificate-format.md specifies, compressed if the name ends in ".zst". The file
/// appears whole or not at all: `progress` may throw until all but the renaming is done. Equal contents give equal
/// bytes.
template <int m>
void write_certificate(const std::filesystem::path& path, const CertificateContent<m>& content,
                       const Progress& progress = no_progress());

}  // namespace delcert
