#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "kernel/formula/formula_map.hpp"
#include "kernel/manifold/submanifold/embedded_manifold.hpp"
#include "kernel/manifold/submanifold/triangle_mesh.hpp"
#include "kernel/number/rational.hpp"
#include "kernel/number/strong.hpp"

namespace delcert {

/// The zero set of equations in a box, or a mesh, as a file describes it (docs/submanifolds.md).
struct SubmanifoldDescription {
  std::string name;
  Dimension dimension{2};
  std::optional<TriangleMesh> mesh;  ///< then there are no variables, equations and box
  std::vector<std::string> variables;
  std::vector<std::string> equations;
  std::vector<std::array<Rational, 2>> box;  ///< for each variable from, to
  std::vector<std::string> homology;         ///< what it should be, from degree 0 on; empty: nothing is said
};

/// M = {f = 0} in a box of ℝᴺ, for f: ℝᴺ → ℝ^q by formulas.
class ZeroSet final : public EmbeddedManifold {
 public:
  /// Throws InputError unless 2 ≤ N ≤ 9, the dimension is N − q, with q ≥ 1, and the box has an interior and N axes;
  /// FormulaError where an equation is none.
  explicit ZeroSet(SubmanifoldDescription description);

  [[nodiscard]] const SubmanifoldDescription& description() const { return description_; }
  /// f. It stays where it is while a copy of this lives.
  [[nodiscard]] const FormulaMap& map() const { return *map_; }

  [[nodiscard]] const std::string& name() const override { return description_.name; }
  [[nodiscard]] std::size_t ambient() const override { return map_->variable_count(); }
  [[nodiscard]] std::size_t codimension() const override { return map_->function_count(); }
  [[nodiscard]] const std::vector<std::string>& homology() const override { return description_.homology; }
  [[nodiscard]] const std::vector<std::array<Rational, 2>>& box() const override { return description_.box; }
  [[nodiscard]] bool is_smooth() const override { return true; }
  /// The function is f, its derivative enclosed by the centred form.
  [[nodiscard]] std::unique_ptr<GraphEvaluation> evaluation() const override;
  /// By Newton's method, from random points of the box.
  [[nodiscard]] std::unique_ptr<ManifoldSampler> sampler(double radius) const override;
  [[nodiscard]] FittedCharts fit_charts(const std::vector<std::vector<Rational>>& centres, const SamplingRadii& radii,
                                        const Progress& progress) const override;
  [[nodiscard]] CoverReport check_cover(const std::vector<TangentChart>& charts,
                                        const Progress& progress) const override;
  /// `find_singular_part`.
  [[nodiscard]] std::optional<BoxPart> singular_part() const override;

 private:
  SubmanifoldDescription description_;
  std::shared_ptr<const FormulaMap> map_;
};

}  // namespace delcert
