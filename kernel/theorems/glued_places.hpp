#pragma once

#include <optional>
#include <vector>

#include "kernel/manifold/gluing/formula_atlas.hpp"

namespace delcert {

/// Where the charts of the file show the perturbed points of the labels of an atlas, enclosed.
template <int m>
class GluedPlaces {
 public:
  /// Throws Undecided, with the label, where it is not certain whether a chart shows a point. Precondition: rounding to
  /// nearest.
  GluedPlaces(const FormulaAtlas<m>& atlas, const PointSet<m>& points);

  [[nodiscard]] std::size_t home(std::uint32_t label) const { return home_[label]; }
  [[nodiscard]] std::size_t labels() const { return home_.size(); }
  [[nodiscard]] std::size_t charts() const { return places_.size(); }
  /// None if the chart does not show it.
  [[nodiscard]] const std::optional<Vector<Interval, m>>& place(std::size_t chart, std::uint32_t label) const {
    return places_[chart][label];
  }

 private:
  std::vector<std::size_t> home_;
  std::vector<std::vector<std::optional<Vector<Interval, m>>>> places_;  // by charts, by labels
};

}  // namespace delcert
