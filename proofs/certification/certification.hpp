#pragma once

#include "proofs/certification/certify_options.hpp"
#include "proofs/certification/run_report.hpp"
#include "support/progress.hpp"

namespace delcert {

/// Certifies a triangulation of a manifold of any family: net, parameters, run, levels; and writes the certificate to
/// `options.output` or, if that is empty, to the file MANIFOLD.delcert.json.zst. The report names it. Where `progress`
/// throws, and where anything else does, no file is left behind.
///
/// Throws InputError, Undecided, and Rejection where a certificate is not reached.
[[nodiscard]] RunReport certified_run(const CertifyOptions& options, const Progress& progress);

}  // namespace delcert
