#pragma once

#include <array>
#include <filesystem>

#include "proofs/certificate/document.hpp"
#include "proofs/certificate/metric_field_claims.hpp"

namespace delcert {

/// Everything that goes into a certificate of a metric field. References are kept.
template <int m>
struct MetricFieldContent {
  const MetricFieldAtlas<m>& atlas;
  const ChartDistortion& distortion;
  const RunParameters& parameters;  ///< mode measured or none
  const PointSet<m>& points;        ///< home coordinates
  const ChartComplex<m>& complex;
  const MetricFieldClaims& claims;
};

/// Writes a certificate as docs/certificate-format.md specifies, as `write_certificate` does.
template <int m>
void write_metric_field_certificate(const std::filesystem::path& path, const MetricFieldContent<m>& content,
                                    const Progress& progress = no_progress());

}  // namespace delcert
