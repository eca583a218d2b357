#pragma once

#include <filesystem>
#include <vector>

#include "kernel/manifold/manifold_file.hpp"
#include "kernel/run/run.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/document.hpp"
#include "proofs/certificate/run_parameters.hpp"
#include "support/progress.hpp"

namespace delcert {

/// Everything that goes into a certificate. References are kept.
template <int m>
struct CertificateContent {
  const ManifoldDescription& manifold;
  const RunParameters& parameters;
  const FlatAtlas<m>& atlas;
  const std::vector<LiftedSimplex<m>>& net_simplices;
  const RunResult<m>& run;
  const Claims& claims;
};

/// Writes a certificate as docs/certificate-format.md specifies, compressed if the name ends in ".zst". The file
/// appears whole or not at all: `progress` may throw until all but the renaming is done. Equal contents give equal
/// bytes.
template <int m>
void write_certificate(const std::filesystem::path& path, const CertificateContent<m>& content,
                       const Progress& progress = no_progress());

}  // namespace delcert
