#pragma once

#include "proofs/drawing/approximate_manifold.hpp"
#include "proofs/drawing/motions.hpp"

namespace delcert {

/// Families whose points are vectors (x₀, y) that a group moves by matrices: flat tori, Euclidean balls, space forms
/// and metric fields. Of curvature 0 x₀ is 1 and y are coordinates of the frame (docs/space-forms.md).
class LinearManifold : public ApproximateManifold {
 public:
  /// Throws InputError where the certificate is not as its format says. Keeps a reference.
  explicit LinearManifold(const CertificateSummary& certificate);

  [[nodiscard]] std::size_t dimension() const override { return m_; }
  [[nodiscard]] double unit(std::uint32_t) const override { return unit_; }
  [[nodiscard]] std::uint32_t cell_sheet(const DrawnSimplex& simplex) override;
  [[nodiscard]] std::uint32_t vertex_sheet(std::uint32_t simplex_sheet, std::uint32_t element) override;
  [[nodiscard]] std::uint32_t simplex_sheet(std::uint32_t vertex_sheet, std::uint32_t element) override;
  [[nodiscard]] std::optional<Place> place(std::uint32_t label, std::uint32_t sheet) const override;
  [[nodiscard]] std::string sheet_text(std::uint32_t sheet) const override;
  [[nodiscard]] std::string step_text(std::uint32_t from, std::uint32_t to) override;
  [[nodiscard]] bool has_isometric_charts() const override { return curvature_ == 0 && charts_.empty(); }
  [[nodiscard]] bool is_closed() const override { return family_ != Family::ball; }
  [[nodiscard]] std::uint32_t relative_element(std::uint32_t from, std::uint32_t to) override;
  [[nodiscard]] std::uint32_t product(std::uint32_t a, std::uint32_t b) override { return motions_.product(a, b); }
  [[nodiscard]] std::optional<ChartPlace> in_chart(std::uint32_t i, std::uint32_t j,
                                                   std::uint32_t element) const override;
  [[nodiscard]] std::optional<double> squared_edge(std::uint32_t i, std::uint32_t element_i, std::uint32_t j,
                                                   std::uint32_t element_j) const override;
  [[nodiscard]] std::vector<DrawingModel> models() const override;
  [[nodiscard]] std::optional<std::vector<double>> drawn(DrawingModel model, const Place& place) const override;
  [[nodiscard]] std::vector<std::pair<Place, Place>> domain() override;

 private:
  enum class Family : unsigned char { torus, ball, space_form, metric_field };
  using Vector = Motions::Vector;

  void read_translations(const CertificateSummary& certificate);
  void read_group(const CertificateSummary& certificate);
  void place_points(const CertificateSummary& certificate);
  [[nodiscard]] Vector point_near(const std::vector<double>& net, const std::vector<double>& tangent) const;
  [[nodiscard]] Motions::Matrix frame(const std::vector<double>& conformal) const;
  /// Lᵀy.
  [[nodiscard]] std::array<double, 4> cartesian(const Vector& x) const;
  [[nodiscard]] double farness(const Vector& x) const;
  [[nodiscard]] bool is_lattice() const { return family_ == Family::torus || family_ == Family::metric_field; }
  [[nodiscard]] std::vector<std::pair<Place, Place>> unit_cell() const;
  [[nodiscard]] std::vector<std::pair<Place, Place>> sphere_around() const;
  [[nodiscard]] std::vector<std::pair<Place, Place>> dirichlet_wires();

  std::size_t m_;
  Family family_ = Family::torus;
  int curvature_ = 0;
  double unit_ = 1;
  double radius_ = 0;             ///< of a ball
  std::vector<double> gram_;      ///< G, of curvature 0 in the frame
  std::vector<double> cholesky_;  ///< L, lower triangular
  Motions motions_;
  std::vector<std::uint32_t> elements_;      ///< of the numbers in the file, 0 the identity
  std::vector<Vector> points_;               ///< perturbed, in the model
  std::vector<std::vector<double>> net_;     ///< as in the file
  std::vector<std::vector<double>> charts_;  ///< of a metric field: A_i, upper triangles
};

}  // namespace delcert
