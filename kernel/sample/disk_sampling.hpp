#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "kernel/random/counter_random.hpp"
#include "kernel/sample/voronoi_cells.hpp"
#include "support/error.hpp"
#include "support/progress.hpp"

namespace delcert {

/// Maximal Poisson-disk sampling: darts while they land, then points in the gaps of Voronoi cells until there are none.
/// `Points` are those of a family of manifolds, with
///
///     bool throw_dart(CounterRandom&)                     a random point, inserted unless another is closer than the
///     radius void insert_about(label, place)                     the point with these coordinates about a point,
///     likewise void look_about(label, std::vector<Vector>&) const  the other points within `DiskSampling::reach`
///     radii, in such coordinates std::size_t size() const
///
/// The coordinates about a point are Cartesian, at the origin the point, and show balls as balls. In doubles: nothing
/// rests on it.
template <int m, class Points>
class DiskSampling {
 public:
  using Cell = typename VoronoiCells<m>::Cell;
  /// Of how many radii about a point others are looked at: more than 2, the less the quicker.
  static constexpr double reach = 2.25;

  /// A reference is kept.
  DiskSampling(Points& points, Curvature curvature, double radius)
      : points_(points), radius_(radius), cells_(curvature, reach * radius) {}

  void throw_darts(std::uint64_t seed, const Progress& progress) {
    constexpr std::uint32_t batch = 4096;
    // Until fewer than one in this many lands.
    constexpr std::uint32_t worth_throwing = 20;
    std::uint32_t dart = 0;
    std::uint32_t landed = batch;
    while (landed * worth_throwing >= batch) {
      progress("throw darts", points_.size(), points_.size());
      landed = 0;
      for (const std::uint32_t end = dart + batch; dart < end; ++dart) {
        CounterRandom random(seed, RandomPurpose::darts, dart, 0);
        if (points_.throw_dart(random)) ++landed;
      }
    }
  }

  void fill_gaps(std::uint64_t seed, const Progress& progress) {
    constexpr std::uint32_t most_rounds = 200;
    // A cell without gaps stays without them, so only these and the new ones are looked at again.
    std::vector<std::uint32_t> open(points_.size());
    for (std::uint32_t label = 0; label < open.size(); ++label) open[label] = label;
    for (std::uint32_t round = 0; !open.empty(); ++round) {
      if (round == most_rounds)
        throw Rejection("maximal Poisson-disk sampling found gaps for " + std::to_string(most_rounds) + " rounds");
      std::vector<std::uint32_t> still_open;
      const auto first_new = static_cast<std::uint32_t>(points_.size());
      for (std::size_t at = 0; at < open.size(); ++at) {
        if (at % 1024 == 0) progress("fill gaps", at, open.size());
        const Cell cell = cell_of(open[at]);
        CounterRandom random(seed, RandomPurpose::gap_filling, open[at], round);
        const auto places = cells_.points_in_gaps(cell, radius_, random);
        for (const auto& place : places) points_.insert_about(open[at], place);
        if (places.empty()) {
          note(cell);
        } else {
          still_open.push_back(open[at]);
        }
      }
      for (auto label = first_new; label < points_.size(); ++label) still_open.push_back(label);
      open = std::move(still_open);
    }
  }

  /// Looks at all cells, for the two that follow.
  void measure() {
    for (std::uint32_t label = 0; label < points_.size(); ++label) note(cell_of(label));
  }
  [[nodiscard]] double covering_radius() const { return covering_radius_; }
  [[nodiscard]] double separation() const { return separation_; }

  [[nodiscard]] Cell cell_of(std::uint32_t label) {
    points_.look_about(label, around_);
    return cells_.cell(around_);
  }

 private:
  void note(const Cell& cell) {
    covering_radius_ = std::max(covering_radius_, cell.farthest_vertex);
    separation_ = std::min(separation_, cell.nearest);
  }

  Points& points_;
  double radius_;
  VoronoiCells<m> cells_;
  std::vector<Vector<double, m>> around_;
  double covering_radius_ = 0;
  double separation_ = std::numeric_limits<double>::infinity();
};

}  // namespace delcert
