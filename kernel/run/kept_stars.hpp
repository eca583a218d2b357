#pragma once

#include <map>
#include <utility>
#include <vector>

#include "kernel/chart/label_range.hpp"
#include "kernel/stars/chart_complex.hpp"
#include "support/progress.hpp"

namespace delcert {

/// The stars of some labels, kept up to date while points move.
template <int m>
class KeptStars {
 public:
  /// References are kept.
  KeptStars(const Atlas<m>& atlas, const ModelGeometry& geometry, double required_protection, LabelRange labels);

  /// Computes what is out of date. Precondition: rounding to nearest.
  void update(const PointSet<m>& points, const Progress& progress);
  /// The stars in whose charts one of these labels had a say are out of date.
  void outdate(const std::vector<Label>& moved);

  /// Of every label, without simplices where no star is kept.
  [[nodiscard]] const std::vector<ChartStar<m>>& stars() const { return stars_; }
  /// These, for good or until they are given back, without which nothing can be brought up to date: they are most of
  /// what a run has in memory.
  [[nodiscard]] std::vector<ChartStar<m>> lend_stars() { return std::exchange(stars_, {}); }
  void take_back(std::vector<ChartStar<m>> stars) { stars_ = std::move(stars); }
  /// The complex of them, where all are kept.
  [[nodiscard]] ChartComplex<m> lend_complex() { return ChartComplex<m>(lend_stars(), interior_); }
  [[nodiscard]] std::vector<StarFailure> failures() const;
  /// Whether some star is certified, and the margins of those that are.
  [[nodiscard]] bool has_margins() const;
  [[nodiscard]] LocalMargins margins() const;

  /// How far a star that was computed has looked at most.
  [[nodiscard]] double farthest_reach() const { return farthest_reach_; }
  /// Where these labels are a part of a whole: what another part has found, and how far points are moved
  /// (`ModelGeometry::displacement_of_the_whole`).
  void include_reach(double reach);
  void set_displacement_of_the_whole(double displacement) { geometry_.displacement_of_the_whole = displacement; }

 private:
  const Atlas<m>& atlas_;
  ModelGeometry geometry_;
  LengthUnits units_;
  double required_protection_;
  LabelRange labels_;
  std::vector<ChartStar<m>> stars_;
  std::vector<LocalMargins> margins_;  // of stars without failures
  std::vector<double> reach_;
  std::map<std::uint32_t, std::vector<StarFailure>> failures_;
  std::vector<bool> interior_;
  std::vector<bool> outdated_;
  double farthest_reach_ = 0;
};

/// How many labels have a failure. Precondition: those of one label follow each other.
[[nodiscard]] std::size_t star_count(const std::vector<StarFailure>& failures);

}  // namespace delcert
