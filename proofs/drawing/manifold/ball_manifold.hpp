#pragma once

#include "proofs/drawing/manifold/linear_manifold.hpp"

namespace delcert {

/// A Euclidean ball: no group, and charts that show a part of it.
class BallManifold : public LinearManifold {
 public:
  /// Throws InputError where the certificate is not as its format says.
  explicit BallManifold(const CertificateSummary& certificate);

  [[nodiscard]] bool is_closed() const override { return false; }
  [[nodiscard]] std::optional<ChartPlace> in_chart(std::uint32_t i, std::uint32_t j,
                                                   std::uint32_t element) const override;
  [[nodiscard]] std::optional<SquaredEdges> squared_edges(const DrawnSimplex&) const override { return std::nullopt; }
  [[nodiscard]] std::vector<std::pair<Place, Place>> domain() override;

 private:
  double radius_;
};

}  // namespace delcert
