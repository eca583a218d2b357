#pragma once

#include "proofs/drawing/manifold/approximate_manifold.hpp"
#include "proofs/drawing/manifold/motions.hpp"

namespace delcert {

/// Families whose points are vectors (x₀, y) that a group moves by matrices: flat tori, Euclidean balls, space forms
/// and metric fields. Of curvature 0 x₀ is 1 and y are coordinates of the frame (docs/space-forms.md); what is said
/// here of charts and models holds of these, unless a family overrides it.
class LinearManifold : public ApproximateManifold {
 public:
  [[nodiscard]] std::size_t dimension() const override { return m_; }
  [[nodiscard]] double unit(std::uint32_t) const override { return unit_; }
  [[nodiscard]] std::uint32_t vertex_sheet(std::uint32_t simplex_sheet, std::uint32_t element) override;
  [[nodiscard]] std::uint32_t simplex_sheet(std::uint32_t vertex_sheet, std::uint32_t element) override;
  [[nodiscard]] std::optional<Place> place(std::uint32_t label, std::uint32_t sheet) const override;
  [[nodiscard]] std::string step_text(std::uint32_t from, std::uint32_t to) override;
  [[nodiscard]] bool has_isometric_charts() const override { return true; }
  [[nodiscard]] std::uint32_t relative_element(std::uint32_t from, std::uint32_t to) override;
  [[nodiscard]] std::uint32_t product(std::uint32_t a, std::uint32_t b) override { return motions_.product(a, b); }
  [[nodiscard]] std::optional<ChartPlace> in_chart(std::uint32_t i, std::uint32_t j,
                                                   std::uint32_t element) const override;
  [[nodiscard]] std::optional<SquaredEdges> squared_edges(const DrawnSimplex& simplex) const override;
  [[nodiscard]] std::vector<DrawingModel> models() const override { return {DrawingModel::unit}; }
  [[nodiscard]] std::optional<std::vector<double>> drawn(DrawingModel model, const Place& place) const override;

 protected:
  using Vector = Motions::Vector;

  /// Without points, with the identity as the only element and the standard basis as the frame. Throws InputError where
  /// the certificate is not as its format says.
  explicit LinearManifold(const CertificateSummary& certificate);
  /// The inner products of the frame, row by row.
  void set_gram(const std::vector<double>& gram);
  /// The points of a family whose certificates have them in coordinates of the frame.
  void place_in_frame(const CertificateSummary& certificate);

  /// Lᵀy.
  [[nodiscard]] std::array<double, 4> cartesian(const Vector& x) const;
  /// A vertex of a simplex, moved by its element.
  [[nodiscard]] Vector vertex(std::uint32_t label, std::uint32_t element) const;
  [[nodiscard]] Vector sum_of_vertices(const DrawnSimplex& simplex) const;

  std::size_t m_;
  double unit_ = 1;
  std::vector<double> cholesky_;  ///< L, lower triangular: LLᵀ are the inner products of the frame
  Motions motions_;
  std::vector<std::uint32_t> elements_{0};  ///< of the numbers in the file, 0 the identity
  std::vector<Vector> points_;              ///< perturbed, in the model
};

/// The points of the net as in the file, one for each label. Throws InputError where there are fewer.
[[nodiscard]] std::vector<std::vector<double>> net_of(const CertificateSummary& certificate);
/// Row by row, of order m.
[[nodiscard]] std::vector<double> unit_matrix(std::size_t m);

}  // namespace delcert
