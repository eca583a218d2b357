#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "kernel/formula/formula_map.hpp"
#include "kernel/number/rational.hpp"
#include "kernel/number/strong.hpp"

namespace delcert {

/// The zero set of equations in a box, as a file describes it (docs/submanifolds.md).
struct SubmanifoldDescription {
  std::string name;
  Dimension dimension{2};
  std::vector<std::string> variables;
  std::vector<std::string> equations;
  std::vector<std::array<Rational, 2>> box;  ///< for each variable from, to
  std::vector<std::string> homology;         ///< what it should be, from degree 0 on; empty: nothing is said
};

inline constexpr std::size_t most_ambient_dimensions = 9;

/// M = {f = 0} in a box of ℝᴺ, for f: ℝᴺ → ℝ^q by formulas. That M is a manifold is for `fit_charts` and `check_cover`
/// to find out.
class ZeroSet {
 public:
  /// Throws InputError unless 2 ≤ N ≤ 9, the dimension is N − q, with q ≥ 1, and the box has an interior and N axes;
  /// FormulaError where an equation is none.
  explicit ZeroSet(SubmanifoldDescription description);

  [[nodiscard]] const SubmanifoldDescription& description() const { return description_; }
  /// f. It stays where it is while a copy of this lives.
  [[nodiscard]] const FormulaMap& map() const { return *map_; }
  /// m, N, q.
  [[nodiscard]] std::size_t dimension() const { return ambient() - codimension(); }
  [[nodiscard]] std::size_t ambient() const { return map_->variable_count(); }
  [[nodiscard]] std::size_t codimension() const { return map_->function_count(); }

 private:
  SubmanifoldDescription description_;
  std::shared_ptr<const FormulaMap> map_;
};

}  // namespace delcert
