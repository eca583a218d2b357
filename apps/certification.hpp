#pragma once

#include "apps/exit_status.hpp"
#include "proofs/certification/certify_options.hpp"

namespace delcert {

/// The command line of `delcert certify`.
struct CertifyCommand : CertifyOptions {
  bool json = false;
};

/// `delcert certify` on a manifold of any family: net, parameters, run, levels, certificate, report.
/// Throws Rejection where a certificate is not reached.
[[nodiscard]] ExitStatus certify(const CertifyCommand& command);

}  // namespace delcert
