#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/formula/parser.hpp"
#include "kernel/formula/toml_formula_reader.hpp"

namespace delcert {

/// The class of a user's own instances: finite sets of points with constraints.
inline constexpr std::string_view point_set_name = "point-set";
inline constexpr int most_points = 12;
inline constexpr int most_dimensions = 8;

/// From least to most, both included.
struct CountRange {
  int least = 1;
  int most = 1;
  [[nodiscard]] bool contains(int count) const { return least <= count && count <= most; }
};

/// What the points of a claim about the class `point-set` are: how many, in which box of ℝᵐ, with which constraints
/// (docs/claim-format.md, "Point sets of your own").
struct PointRules {
  CountRange number;
  CountRange dimension;
  std::vector<ParameterRange> box;  ///< of each coordinate, or one for all of them; bounded
  std::vector<std::string> constraints;
  Rational least_acceptance;  ///< a smaller share of successful draws counts as hardly attacked

  [[nodiscard]] const ParameterRange& box_of(std::size_t axis) const { return box.size() == 1 ? box[0] : box.at(axis); }
};

/// Reads the table `points` of a claim but for its constraints, which are formulas. Throws InputError with the place of
/// what is wrong.
[[nodiscard]] PointRules read_point_rules(const TomlFormulaReader& reader, const toml::node& node);

/// What the box says of the points p, as formulas.
[[nodiscard]] std::vector<std::string> box_formulas(const PointRules& rules);

/// The lines of TOML from which the same rules are read, constraints included.
[[nodiscard]] std::string point_rules_text(const PointRules& rules);

}  // namespace delcert
