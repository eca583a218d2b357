#pragma once

#include "apps/certify_options.hpp"
#include "kernel/run/chart_run.hpp"

namespace delcert {

// What `delcert certify` does alike wherever a manifold is seen through charts: on space forms and on metric fields.

/// The options of the command line in measured mode, completed for this dimension.
[[nodiscard]] RunParameters measured_run_parameters(const CertifyOptions& options, Dimension dimension,
                                                    const Rational& separation);

/// What the options ask of a run on a net of this sampling radius.
[[nodiscard]] RunRequest run_request(const CertifyOptions& options, const Rational& sampling_radius);

/// Throws Rejection, which names the stars that failed, unless everything that was asked for is certified.
template <int m>
void require_certified(const ChartRun<m>& run);

}  // namespace delcert
