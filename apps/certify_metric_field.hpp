#pragma once

#include "apps/certify_options.hpp"
#include "apps/exit_status.hpp"
#include "kernel/manifold/gluing/metric_field.hpp"

namespace delcert {

/// `delcert certify` on a metric field of a torus: verifies that it is a metric, makes or reads a net, measures the
/// charts, runs the algorithm in measured mode, and writes a certificate. Throws Rejection where that is not reached.
[[nodiscard]] ExitStatus certify_metric_field(const CertifyOptions& options, const MetricFieldDescription& description);

}  // namespace delcert
