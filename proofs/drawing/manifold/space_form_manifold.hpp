#pragma once

#include <nlohmann/json_fwd.hpp>

#include "proofs/drawing/manifold/linear_manifold.hpp"

namespace delcert {

/// A space form: points are in the model x₀² + K|y|² = 1, in the standard basis where K ≠ 0; charts are exponential.
class SpaceFormManifold : public LinearManifold {
 public:
  /// Throws InputError where the certificate is not as its format says.
  explicit SpaceFormManifold(const CertificateSummary& certificate);

  [[nodiscard]] std::uint32_t cell_sheet(const DrawnSimplex& simplex) override;
  /// A word in the generators g1, g2, … and, of curvature 0, the translations e1, e2, …; "1" for the identity.
  [[nodiscard]] std::string sheet_text(std::uint32_t sheet) const override;
  [[nodiscard]] bool has_isometric_charts() const override { return curvature_ == 0; }
  [[nodiscard]] std::optional<ChartPlace> in_chart(std::uint32_t i, std::uint32_t j,
                                                   std::uint32_t element) const override;
  [[nodiscard]] std::optional<SquaredEdges> squared_edges(const DrawnSimplex& simplex) const override;
  [[nodiscard]] std::vector<DrawingModel> models() const override;
  [[nodiscard]] std::optional<std::vector<double>> drawn(DrawingModel model, const Place& place) const override;
  [[nodiscard]] std::vector<std::pair<Place, Place>> domain() override;

 private:
  void read_letters(const nlohmann::ordered_json& json);
  void add_letter(const std::vector<double>& letter);
  void read_elements(const CertificateSummary& certificate);
  [[nodiscard]] Vector point_near(const std::vector<double>& net, const std::vector<double>& tangent) const;
  [[nodiscard]] Motions::Matrix frame(const std::vector<double>& conformal) const;
  [[nodiscard]] double farness(const Vector& x) const;
  [[nodiscard]] std::vector<std::uint32_t> nearest_copies();
  [[nodiscard]] Vector wall_before(const Vector& image) const;

  int curvature_;
  std::vector<Motions::Matrix> to_charts_;  ///< of each label: takes its point of the net to the origin
};

}  // namespace delcert
