#pragma once

#include "apps/certify_options.hpp"
#include "apps/exit_status.hpp"

namespace delcert {

/// `delcert certify` on a manifold of any family: net, parameters, run, levels, certificate, report.
/// Throws Rejection where a certificate is not reached.
[[nodiscard]] ExitStatus certify(const CertifyOptions& options);

}  // namespace delcert
