#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofs/certificate/reader.hpp"
#include "proofs/drawing/manifold/squared_edges.hpp"

namespace delcert {

/// Where points are drawn: the coordinates that a file for other programs has (docs/export.md).
enum class DrawingModel : unsigned char {
  unit,       ///< Cartesian coordinates of a flat manifold; of a sphere, those of the unit sphere around
  conformal,  ///< y/(1 + x₀): the disk or ball of Poincaré, and the stereographic projection of a sphere from −o
  stereographic,  ///< the same
  gnomonic,       ///< y/x₀: Klein's disk or ball, and half a sphere from its centre
  space           ///< the coordinates of ℝᴺ
};
[[nodiscard]] std::string_view name_of(DrawingModel model);

/// A simplex of a certificate: its position, its labels in increasing order, and for each the number of its element.
struct DrawnSimplex {
  std::size_t position = 0;
  using Numbers = boost::container::static_vector<std::uint32_t, most_vertices_of_a_simplex>;
  Numbers labels;
  Numbers elements;
};

/// The manifold and the points of a certificate in doubles, without error bounds: for drawing, never for deciding.
///
/// A *sheet* is what tells copies of a label apart: the number of a group element, 0 the identity; on an atlas by
/// formulas the number of a chart; elsewhere there is the sheet 0 only.
class ApproximateManifold {
 public:
  /// In coordinates of a model that depends on the family; unused entries are 0.
  using Place = std::array<double, 9>;
  using ChartPlace = std::array<double, 4>;

  ApproximateManifold() = default;
  ApproximateManifold(const ApproximateManifold&) = delete;
  ApproximateManifold& operator=(const ApproximateManifold&) = delete;
  virtual ~ApproximateManifold() = default;

  [[nodiscard]] virtual std::size_t dimension() const = 0;
  /// ε_i, the unit of lengths at a label.
  [[nodiscard]] virtual double unit(std::uint32_t label) const = 0;

  // What there is of copies.

  /// The sheet on which the certificate has a label that is drawn once.
  [[nodiscard]] virtual std::uint32_t home_sheet(std::uint32_t) const { return 0; }
  /// The sheet of the simplex in the one fundamental cell: that of the copy in which element 0 is at the identity.
  [[nodiscard]] virtual std::uint32_t cell_sheet(const DrawnSimplex&) { return 0; }
  /// The sheet of a vertex with this element of a simplex on this sheet.
  [[nodiscard]] virtual std::uint32_t vertex_sheet(std::uint32_t, std::uint32_t) { return 0; }
  /// The other way round: the sheet of the simplex with this one among its vertices.
  [[nodiscard]] virtual std::uint32_t simplex_sheet(std::uint32_t, std::uint32_t) { return 0; }
  /// None where it is not shown on that sheet (of a group: never).
  [[nodiscard]] virtual std::optional<Place> place(std::uint32_t label, std::uint32_t sheet) const = 0;
  /// "0 1 0", "g2 e1^-1"; empty where there is only one sheet.
  [[nodiscard]] virtual std::string sheet_text(std::uint32_t) const { return ""; }
  /// What takes the one sheet to the other.
  [[nodiscard]] virtual std::string step_text(std::uint32_t, std::uint32_t) { return ""; }

  // What is measured.

  /// Whether lengths are the same in all charts.
  [[nodiscard]] virtual bool has_isometric_charts() const { return false; }
  /// Whether every simplex at a point is in the certificate; else charts show points of which there is no star.
  [[nodiscard]] virtual bool is_closed() const { return true; }
  /// The number of the element that leads from the first to the second.
  [[nodiscard]] virtual std::uint32_t relative_element(std::uint32_t, std::uint32_t) { return 0; }
  [[nodiscard]] virtual std::uint32_t product(std::uint32_t, std::uint32_t) { return 0; }
  /// Label j, moved by an element, in chart i. None where that is not shown.
  [[nodiscard]] virtual std::optional<ChartPlace> in_chart(std::uint32_t i, std::uint32_t j,
                                                           std::uint32_t element) const = 0;
  /// The squares of the lengths that the piecewise flat metric of level 6 gives to the edges. None where no such metric
  /// is spoken of.
  [[nodiscard]] virtual std::optional<SquaredEdges> squared_edges(const DrawnSimplex&) const { return std::nullopt; }

  // What is shown.

  /// The models that the family can be drawn in, the usual one first.
  [[nodiscard]] virtual std::vector<DrawingModel> models() const = 0;
  /// None where the model does not show the place. Precondition: one of `models`.
  [[nodiscard]] virtual std::optional<std::vector<double>> drawn(DrawingModel model, const Place& place) const = 0;
  /// Wires of a fundamental domain, piece by piece; none where none is known.
  [[nodiscard]] virtual std::vector<std::pair<Place, Place>> domain() { return {}; }
};

/// Throws InputError for a family that is not known, and for what is not as the format says.
[[nodiscard]] std::unique_ptr<ApproximateManifold> approximate_manifold(const CertificateSummary& certificate);

}  // namespace delcert
