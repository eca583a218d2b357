#pragma once

#include "proofs/drawing/manifold/linear_manifold.hpp"

namespace delcert {

/// A flat torus: the group is the lattice ℤᵐ of the frame.
class TorusManifold : public LinearManifold {
 public:
  /// Throws InputError where the certificate is not as its format says.
  explicit TorusManifold(const CertificateSummary& certificate);

  [[nodiscard]] std::uint32_t cell_sheet(const DrawnSimplex& simplex) override;
  [[nodiscard]] std::string sheet_text(std::uint32_t sheet) const override;
  [[nodiscard]] std::vector<std::pair<Place, Place>> domain() override;

 protected:
  /// The elements, but neither points nor frame: of tori with another metric.
  struct OnlyElements {};
  TorusManifold(const CertificateSummary& certificate, OnlyElements);
};

}  // namespace delcert
