#pragma once

#include "proofs/drawing/manifold/torus_manifold.hpp"

namespace delcert {

/// A metric field on a torus: charts are the affine maps x ↦ A_i(x − p_i).
class MetricFieldManifold : public TorusManifold {
 public:
  /// Throws InputError where the certificate is not as its format says.
  explicit MetricFieldManifold(const CertificateSummary& certificate);

  [[nodiscard]] bool has_isometric_charts() const override { return false; }
  [[nodiscard]] std::optional<ChartPlace> in_chart(std::uint32_t i, std::uint32_t j,
                                                   std::uint32_t element) const override;
  [[nodiscard]] std::optional<SquaredEdges> squared_edges(const DrawnSimplex&) const override { return std::nullopt; }

 private:
  std::vector<std::vector<double>> net_;
  std::vector<std::vector<double>> charts_;  ///< A_i, upper triangles
};

}  // namespace delcert
