#pragma once

#include "apps/certify_options.hpp"
#include "apps/exit_status.hpp"
#include "kernel/manifold/quotient/space_form.hpp"

namespace delcert {

/// `delcert certify` on a quotient of a sphere, of Euclidean or of hyperbolic space: verifies the group, makes or reads
/// a net, runs the algorithm in measured mode, and writes a certificate. Throws Rejection where that is not reached.
[[nodiscard]] ExitStatus certify_space_form(const CertifyOptions& options, const SpaceFormDescription& description);

}  // namespace delcert
