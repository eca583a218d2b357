#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "kernel/manifold/submanifold/tangent_chart.hpp"
#include "kernel/number/interval.hpp"
#include "kernel/stars/chart_complex.hpp"

namespace delcert {

/// Where the labels of a complex are in ℝᴺ, with their charts, and how near to the manifold.
struct GraphVertices {
  const EmbeddedManifold& manifold;
  const std::vector<TangentChart>& charts;
  std::vector<Interval> positions;  ///< p′, N coordinates for each label
  std::vector<double> residuals;    ///< upper bounds of |f(p′)|; empty: they are on M
  /// Of few digits; lengths that are the same for all labels, but for these factors, count so many times. Empty: 1.
  std::vector<double> units = {};

  [[nodiscard]] const Interval* position(std::uint32_t label) const { return &positions[label * manifold.ambient()]; }
  [[nodiscard]] double unit(std::uint32_t label) const { return units.empty() ? 1 : units[label]; }
  /// The least of those of the vertices.
  template <std::size_t size>
  [[nodiscard]] double unit(const std::array<std::uint32_t, size>& simplex) const {
    double result = unit(simplex[0]);
    for (const std::uint32_t label : simplex) result = std::min(result, unit(label));
    return result;
  }
  [[nodiscard]] double residual(std::uint32_t label) const { return residuals.empty() ? 0 : residuals[label]; }
};

/// Why a simplex does not pass the rules 5.fibre and 5.contract of docs/levels/submanifolds.md.
enum class GraphCause : unsigned char {
  undefined,     ///< an equation or its derivatives are not certainly defined around it
  outside,       ///< it is not, with the displacement, in the cylinders of its labels
  fibre,         ///< ‖1 − J·W‖ < 1 fails: fibres may meet M elsewhere or not at all
  displacement,  ///< M may be farther than the displacement
  degenerate,    ///< its projection to the chart of one of its labels is not certainly a simplex
  contraction,   ///< γ < 1 fails
};
[[nodiscard]] const char* description_of(GraphCause cause);

/// What level 5 asks of one m-simplex σ, with the displacement ω given: upper bounds but for the altitudes.
template <int m>
struct GraphSimplex {
  std::optional<GraphCause> cause;  ///< none if the rules hold; otherwise what follows may be missing
  double edge = 0;                  ///< ℓ_σ
  double shift = 0;                 ///< s_σ
  double displacement = 0;          ///< max ‖W_v‖·s_σ
  double contraction = 0;           ///< the greatest γ_{σ,i}
  double least_stretch = 0;  ///< level 6: distances on σ, moved to M, are at least this times as long; a lower bound
  double greatest_stretch = 0;  ///< and at most this times
  double normal = 0;            ///< the sine of the angle between σ and the tangent spaces of M over it
  std::array<double, static_cast<std::size_t>(m) + 1> altitudes{};  ///< at each vertex, in its own chart: lower bounds
  std::array<double, static_cast<std::size_t>(m) + 1> rooms{};  ///< and less γ times the longest edge there, likewise
  std::array<double, static_cast<std::size_t>(m) + 1> below_lid{};  ///< and how far all are below its lid, likewise
};

/// Measures simplices. Has scratch memory: one for each thread. All but the constructor needs a `RoundingGuard`, and
/// that too.
template <int m>
class GraphSimplexCheck {
 public:
  /// Keeps references.
  explicit GraphSimplexCheck(const GraphVertices& vertices);

  /// Rules 5.fibre and 5.contract for the simplex, of vertices that are on M or not. With a displacement that is too
  /// small, or with 0, what is measured still says how large it should be.
  [[nodiscard]] GraphSimplex<m> measure(const LabelSimplex<m>& simplex, double displacement);

  /// ‖EᵢᵀW_v‖, an upper bound.
  [[nodiscard]] double lateral(std::uint32_t i, std::uint32_t v) const;
  /// What `coordinate` of the chart of i says of p′_v: below m in its plane, from m on heights.
  [[nodiscard]] Interval coordinate(std::uint32_t i, std::uint32_t v, std::size_t column) const {
    return vertices_.charts[i].enclosed().coordinate(vertices_.position(v), column);
  }
  /// The gradients of the barycentric coordinates of the simplex in the chart of i. None unless it is certainly not
  /// degenerate.
  using Gradients = std::array<Vector<Interval, m>, static_cast<std::size_t>(m) + 1>;
  [[nodiscard]] std::optional<Gradients> gradients(std::uint32_t i, const LabelSimplex<m>& simplex) const;

  /// W_v = N_v·Y_v, N×q.
  void fibre(std::uint32_t v, Interval* w) const;

 private:
  /// The same of W_v.
  [[nodiscard]] double lateral(std::uint32_t i, const Interval* w) const;
  [[nodiscard]] bool enclose_derivatives(const LabelSimplex<m>& simplex, double displacement);
  /// In the chart of the label that stands at this place.
  [[nodiscard]] const DerivativeHull& hull(std::size_t at) const { return hulls_[hulls_.size() == 1 ? 0 : at]; }
  /// ‖J‖ there, an upper bound but for the spread.
  [[nodiscard]] double size_of(std::size_t at) const { return sizes_[sizes_.size() == 1 ? 0 : at]; }
  [[nodiscard]] double defect(const DerivativeHull& hull, std::size_t w) const;
  /// What the simplex is in the chart of the label that stands at this place; adds to what is known of it. None if γ <
  /// 1 fails.
  [[nodiscard]] std::optional<double> contraction(std::size_t at, const LabelSimplex<m>& simplex,
                                                  const Gradients& gradients, const Interval& theta,
                                                  GraphSimplex<m>& result) const;
  [[nodiscard]] Interval longest_edge(std::size_t at, const LabelSimplex<m>& simplex) const;
  /// Of ker J to the plane of the chart, for all J that may be on the simplex; infinite if unknown.
  [[nodiscard]] double steepness(std::uint32_t i, const DerivativeHull& hull) const;
  /// 5.fibre. Sets `below_lid`.
  [[nodiscard]] bool lies_inside(const LabelSimplex<m>& simplex, double displacement, GraphSimplex<m>& result) const;

  const GraphVertices& vertices_;
  std::size_t n_, q_;
  std::unique_ptr<GraphEvaluation> evaluation_;
  std::vector<DerivativeHull> hulls_;  // one, or one for each vertex
  std::vector<double> sizes_;          // of the matrices of each, their norms
  std::vector<Interval> fibres_;       // W of each vertex, N×q
};

}  // namespace delcert
