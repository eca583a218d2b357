#pragma once

#include <string>
#include <vector>

#include "kernel/manifold/gluing/cell_map.hpp"
#include "kernel/number/strong.hpp"

namespace delcert {

/// Charts, their domains and the transitions between them, as a file describes them (docs/atlases.md).
struct FormulaAtlasDescription {
  struct Chart {
    std::string name;
    std::vector<std::string> variables;
    Sides domain;  ///< an open box
    Sides core;    ///< a closed box inside
  };
  struct Transition {
    std::size_t from = 0;  ///< charts, by their places
    std::size_t to = 0;
    std::vector<std::string> map;      ///< in the variables of `from`
    std::vector<std::string> inverse;  ///< in those of `to`
    std::vector<std::string> where;    ///< polynomials in the variables of `from`: above 0
  };
  std::string name;
  Dimension dimension{2};  ///< 2 or 3
  std::vector<Chart> charts;
  std::vector<Transition> transitions;
  std::vector<std::string> homology;  ///< may be empty: nothing is expected
};

/// The charts of a description with all transitions in both directions. That these are inverse to each other is
/// verified, as an identity of rational functions, piece by piece; nothing else (`check_gluing` does the rest).
class ChartGluing {
 public:
  /// From one chart to another: a transition of the file, or the inverse of one. Its domain are the points of the open
  /// box of `from` at which the conditions hold that the pieces have: one of a rational map, several of a piecewise
  /// linear one, whose regions cover ℝᵐ. Each has formulas.
  struct Transition {
    std::size_t from;
    std::size_t to;
    std::string name;  ///< for messages
    std::vector<CellMap> pieces;
  };

  /// Throws InputError, naming the transition, for what is no rational function of moderate size and not piecewise
  /// linear, or, among conditions, no polynomial;
  /// Rejection (atlas.inverse), naming the coordinate too, where a map and its inverse are not inverse to each other.
  /// Precondition: charts have the dimension's sizes, transitions join different charts; rounding to nearest.
  explicit ChartGluing(FormulaAtlasDescription description);

  [[nodiscard]] const FormulaAtlasDescription& description() const { return description_; }
  [[nodiscard]] std::size_t dimension() const { return static_cast<std::size_t>(description_.dimension.value); }
  [[nodiscard]] std::size_t chart_count() const { return description_.charts.size(); }
  [[nodiscard]] const FormulaAtlasDescription::Chart& chart(std::size_t at) const { return description_.charts[at]; }
  /// 2k is number k of the file, 2k + 1 its inverse.
  [[nodiscard]] const std::vector<Transition>& transitions() const { return transitions_; }
  [[nodiscard]] static std::size_t opposite(std::size_t transition) { return transition ^ 1U; }

 private:
  FormulaAtlasDescription description_;
  RingPointer ring_;
  std::vector<Transition> transitions_;
};

}  // namespace delcert
