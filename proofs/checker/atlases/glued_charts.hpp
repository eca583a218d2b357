#pragma once

#include <memory>
#include <optional>

#include "proofs/checker/atlases/gluing_cells.hpp"
#include "proofs/checker/charts/affine_charts.hpp"
#include "proofs/checker/geometry/near_points.hpp"

namespace delcert::checker {

/// The affine charts of labels on a manifold that is glued of boxes: chart i is a piece of the box of its home.
class GluedCharts : public AffineCharts {
 public:
  explicit GluedCharts(const Certificate& c);

  /// The rules atlas.*, whatever level is looked at. All else presumes that they hold.
  std::string check(Report& report);

  const Gluing& gluing() const { return gluing_; }
  const std::vector<Passage>& passages() const { return passages_; }
  PassageValues& values(std::size_t passage) const { return values_[passage]; }
  std::size_t home(Label i) const { return homes_[i]; }
  using AffineCharts::home;

  /// Where a chart of the file shows the perturbed point of a label; null if it does not.
  const Vector<Interval>* place(std::size_t chart, Label j) const;

  ShownPoints<Rational> shown(Label i, const Quantity& radius) const override;
  std::string fault_of_patches(Level level) const override;

 private:
  /// A perturbed point in a chart of the file; without a passage at home.
  struct Appearance {
    Label label;
    std::optional<std::size_t> passage;
    Vector<Interval> place;
  };
  Vector<Rational> exact_place(const Appearance& seen) const;
  void find_appearances();
  bool is_in_domain(std::size_t passage, Label j, Vector<Interval>& place) const;
  void check_patch(Label i, Report& report) const;
  void check_distortion(Label j, Report& report) const;
  Verdict is_stretched_little(Label j, std::size_t passage, const Cell& cell) const;
  void check_stretches(Label j, std::size_t passage, const Cell& cell, std::size_t halvings, Report& report) const;

  const Gluing& gluing_;
  std::vector<std::size_t> homes_;
  std::vector<Passage> passages_;
  mutable std::vector<PassageValues> values_;
  std::vector<std::vector<Appearance>> shown_;  // by charts of the file, sorted by labels
  std::vector<NearPoints> near_points_;
  std::vector<NearPoints> near_centres_;  // of labels at home in each chart
  std::vector<std::vector<Label>> at_home_;
  double greatest_stretch_ = 0;
};

/// Level 5, as the functions of run.hpp: straight in home charts, and blended between them, simplices triangulate M.
std::string check_blended_triangulation(const GluedCharts& charts, Report& report);

}  // namespace delcert::checker
