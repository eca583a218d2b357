#pragma once

#include <memory>

#include "kernel/formula/formula_map.hpp"
#include "proofs/drawing/manifold/approximate_manifold.hpp"

namespace delcert {

/// Atlases by formulas. Sheets are the charts of the file, which are drawn side by side, in their order along the first
/// axis; a place is the number of a chart and coordinates in it.
class ChartManifold : public ApproximateManifold {
 public:
  /// Throws InputError where the certificate is not as its format says.
  explicit ChartManifold(const CertificateSummary& certificate);

  [[nodiscard]] std::size_t dimension() const override { return m_; }
  [[nodiscard]] double unit(std::uint32_t) const override { return unit_; }
  [[nodiscard]] std::uint32_t home_sheet(std::uint32_t label) const override { return homes_.at(label); }
  [[nodiscard]] std::uint32_t cell_sheet(const DrawnSimplex& simplex) override;
  [[nodiscard]] std::uint32_t vertex_sheet(std::uint32_t simplex_sheet, std::uint32_t) override {
    return simplex_sheet;
  }
  [[nodiscard]] std::uint32_t simplex_sheet(std::uint32_t vertex_sheet, std::uint32_t) override { return vertex_sheet; }
  [[nodiscard]] std::optional<Place> place(std::uint32_t label, std::uint32_t sheet) const override;
  [[nodiscard]] std::string sheet_text(std::uint32_t sheet) const override { return fields_.at(sheet).name; }
  [[nodiscard]] std::string step_text(std::uint32_t from, std::uint32_t to) override {
    return sheet_text(from) + " -> " + sheet_text(to);
  }
  [[nodiscard]] std::optional<ChartPlace> in_chart(std::uint32_t i, std::uint32_t j,
                                                   std::uint32_t element) const override;
  [[nodiscard]] std::vector<DrawingModel> models() const override { return {DrawingModel::unit}; }
  [[nodiscard]] std::optional<std::vector<double>> drawn(DrawingModel model, const Place& place) const override;
  /// The boxes of the charts.
  [[nodiscard]] std::vector<std::pair<Place, Place>> domain() override;

 private:
  /// A chart of the file.
  struct Field {
    std::string name;
    std::vector<std::array<double, 2>> sides;
    double shift = 0;  ///< of its first axis, so that no two overlap
  };
  /// A transition, or a piece of one.
  struct Transition {
    std::uint32_t from;
    std::uint32_t to;
    std::unique_ptr<FormulaMap> map;
    std::unique_ptr<FormulaMap> condition;  ///< above 0, in the variables of the chart that `on_target` says
    bool on_target;
    std::unique_ptr<FormulaEvaluation<double>> values;
    std::unique_ptr<FormulaEvaluation<double>> conditions;
    std::unique_ptr<FormulaMap> border;  ///< of a piece of several: at least 0 where it counts
    std::unique_ptr<FormulaEvaluation<double>> borders;
  };
  [[nodiscard]] bool is_inside(std::uint32_t field, const double* x) const;

  std::size_t m_;
  double unit_ = 1;
  std::vector<Field> fields_;
  std::vector<Transition> transitions_;
  std::vector<std::uint32_t> homes_;
  std::vector<std::vector<double>> centres_;
  std::vector<std::vector<double>> matrices_;  ///< A_i, upper triangles
  std::vector<std::vector<double>> points_;    ///< c_i + A_i⁻¹y_i
};

}  // namespace delcert
