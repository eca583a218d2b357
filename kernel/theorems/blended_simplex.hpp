#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "kernel/manifold/gluing/piecewise_values.hpp"
#include "kernel/stars/chart_complex.hpp"
#include "kernel/theorems/glued_places.hpp"

namespace delcert {

/// Why it is not known how a simplex lies in M.
enum class BlendCause : unsigned char {
  place,       ///< a home chart of it does not show a vertex
  box,         ///< it is not inside the box of a home chart
  transition,  ///< no transition between its home charts is defined on all of it
  fold         ///< the blend may not be injective
};
[[nodiscard]] std::string_view description_of(BlendCause cause);

/// Blends with more are not kept where there is a choice: readers' bounds are a little larger.
inline constexpr double most_contraction = 0.9375;

/// What level 5 of an atlas by formulas (docs/levels/atlases.md) knows of a simplex. Bounds are upper ones.
struct BlendedSimplex {
  bool is_seam = false;     ///< its vertices have several home charts
  double displacement = 0;  ///< λ_q
  double contraction = 0;   ///< g_q, or γ with (1 − γ)ᵐ ≤ det F
  std::optional<BlendCause> cause;
};

/// Measures simplices, one after the other: rule 5.blend. Has scratch memory. Needs a `RoundingGuard`, in
/// the constructor too.
template <int m>
class BlendedSimplexCheck {
 public:
  /// Keeps references.
  BlendedSimplexCheck(const FormulaAtlas<m>& atlas, const GluedPlaces<m>& places);

  [[nodiscard]] BlendedSimplex measure(const LabelSimplex<m>& simplex);

  /// The home charts of the vertices, each once, in the order of the file.
  [[nodiscard]] std::vector<std::size_t> homes_of(const LabelSimplex<m>& simplex) const;
  /// The least vertex that has this home.
  [[nodiscard]] std::uint32_t representative(const LabelSimplex<m>& simplex, std::size_t home) const;

 private:
  struct Step;
  struct Derivatives;
  [[nodiscard]] bool is_open_box(const Cell& cell, std::size_t chart) const;
  [[nodiscard]] Cell box_about(const LabelSimplex<m>& simplex, std::size_t chart, double displacement) const;
  [[nodiscard]] std::optional<std::size_t> transition_on(const Cell& box, std::size_t from, std::size_t to);
  [[nodiscard]] std::optional<Derivatives> derivatives(const LabelSimplex<m>& simplex, std::size_t from, std::size_t to,
                                                       std::size_t transition, const Cell& box, double displacement);
  [[nodiscard]] std::optional<Step> step(const LabelSimplex<m>& simplex, std::size_t from, std::size_t to,
                                         std::size_t transition, const Cell& box, double displacement);
  [[nodiscard]] double contraction_by_volume(const LabelSimplex<m>& simplex, std::size_t from, std::size_t to,
                                             std::size_t transition, const Cell& box);

  const FormulaAtlas<m>& atlas_;
  const GluedPlaces<m>& places_;
  std::vector<PiecewiseCells> on_cells_;
  std::vector<PiecewiseValues<Interval>> maps_;
};

}  // namespace delcert
