#pragma once

#include <memory>

#include "kernel/manifold/submanifold/tangent_chart.hpp"
#include "proofs/drawing/manifold/approximate_manifold.hpp"

namespace delcert {

/// Zero sets of equations, and meshes: points of ℝᴺ, in charts of nearly tangent planes.
class TangentManifold : public ApproximateManifold {
 public:
  /// Finds the point of M over the coordinates of each label. Throws InputError where there is none, and where the
  /// certificate is not as its format says.
  explicit TangentManifold(const CertificateSummary& certificate);

  [[nodiscard]] std::size_t dimension() const override { return m_; }
  [[nodiscard]] double unit(std::uint32_t label) const override { return units_[label]; }
  [[nodiscard]] std::optional<Place> place(std::uint32_t label, std::uint32_t) const override {
    return places_.at(label);
  }
  [[nodiscard]] std::optional<ChartPlace> in_chart(std::uint32_t i, std::uint32_t j,
                                                   std::uint32_t element) const override;
  [[nodiscard]] std::optional<SquaredEdges> squared_edges(const DrawnSimplex& simplex) const override;
  [[nodiscard]] std::vector<DrawingModel> models() const override { return {DrawingModel::space}; }
  [[nodiscard]] std::optional<std::vector<double>> drawn(DrawingModel model, const Place& place) const override;

 private:
  std::size_t m_;
  std::size_t ambient_ = 0;
  std::vector<EnclosedChart<double>> charts_;
  std::vector<Place> places_;
  std::vector<double> units_;
};

}  // namespace delcert
