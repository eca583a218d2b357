#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "kernel/manifold/submanifold/tangent_chart.hpp"
#include "kernel/number/interval.hpp"
#include "kernel/stars/chart_complex.hpp"

namespace delcert {

/// Where the labels of a complex are in ℝᴺ, with their charts, and how near to the zero set.
struct GraphVertices {
  const ZeroSet& zero_set;
  const std::vector<TangentChart>& charts;
  std::vector<Interval> positions;  ///< p′, N coordinates for each label
  std::vector<double> residuals;    ///< upper bounds of |f(p′)|; empty: they are on M

  [[nodiscard]] const Interval* position(std::uint32_t label) const { return &positions[label * zero_set.ambient()]; }
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
  bool is_under_lid = false;        ///< 5i.lid: heights with 3ω below ζ
  double least_stretch = 0;  ///< level 6: distances on σ, moved to M, are at least this times as long; a lower bound
  double greatest_stretch = 0;  ///< and at most this times
  double normal = 0;            ///< the sine of the angle between σ and the tangent spaces of M over it
  std::array<double, static_cast<std::size_t>(m) + 1> altitudes{};  ///< at each vertex, in its own chart: lower bounds
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

 private:
  /// W_v = N_v·Y_v, N×q.
  void fibre(std::uint32_t v, Interval* w) const;
  [[nodiscard]] bool enclose_derivatives(const LabelSimplex<m>& simplex, double displacement);
  [[nodiscard]] double defect(std::size_t v, std::size_t w) const;
  [[nodiscard]] Interval shift_of(const LabelSimplex<m>& simplex, const Interval& edge_squared,
                                  const Interval& theta) const;
  /// What the simplex is in the chart of the label that stands at this place; adds to what is known of it. None if γ <
  /// 1 fails.
  [[nodiscard]] std::optional<double> contraction(std::size_t at, const LabelSimplex<m>& simplex,
                                                  const Gradients& gradients, const Interval& theta,
                                                  GraphSimplex<m>& result) const;
  /// Of ker J to the plane of the chart, for all J that may be on the simplex; infinite if unknown.
  [[nodiscard]] double steepness(std::uint32_t i) const;
  /// 5.fibre and 5i.lid.
  [[nodiscard]] std::array<bool, 2> lies_inside(const LabelSimplex<m>& simplex, double displacement) const;

  const GraphVertices& vertices_;
  std::size_t n_, q_;
  FormulaEvaluation<Interval> evaluation_;
  std::vector<Interval> box_, middle_, f_, at_middle_, first_, second_;
  std::vector<Interval> derivatives_;  // J at each vertex by the centred form, q×N
  std::vector<Interval> fibres_;       // W of each vertex, N×q
  Interval spread_;                    // ‖D²f‖·ω: how much J may differ from the hull of those
};

}  // namespace delcert
