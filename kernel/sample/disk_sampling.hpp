#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "kernel/parallel/parts.hpp"
#include "kernel/random/counter_random.hpp"
#include "kernel/sample/voronoi_cells.hpp"
#include "support/error.hpp"
#include "support/progress.hpp"

namespace delcert {

/// Points that are proposed by several threads and inserted by one, round by round (docs/decisions/nets-in-rounds.md):
///
///     struct Candidate                                          a point that may be inserted
///     optional<Candidate> dart(CounterRandom&) const            a random point; none if another is closer than the
///                                                               radius
///     optional<Candidate> candidate_about(label, place) const   the point with these coordinates about a point;
///                                                               likewise
///     void begin_round()                                        from here on points are new
///     bool insert(const Candidate&)                             unless a new point is closer than the radius
///     bool has_new_about(label) const                           whether a new point is within the reach
template <class Points>
concept SampledInRounds = requires(Points& points, const Points& same, CounterRandom& random,
                                   const typename Points::Candidate& candidate) {
  { same.dart(random) } -> std::same_as<std::optional<typename Points::Candidate>>;
  points.begin_round();
  { points.insert(candidate) } -> std::same_as<bool>;
  { same.has_new_about(0U) } -> std::same_as<bool>;
};

/// Maximal Poisson-disk sampling: darts while they land, then points in the gaps of Voronoi cells until there are none.
/// `Points` are those of a family of manifolds, with
///
///     void look_about(label, std::vector<Vector>&) const  the other points within `DiskSampling::reach` radii, in
///                                                         coordinates about a point
///     std::size_t size() const
///
/// and what `SampledInRounds` says, or
///
///     bool throw_dart(CounterRandom&)                     a random point, inserted unless another is closer than the
///                                                         radius
///     void insert_about(label, place)                     the point with these coordinates about a point, likewise
///
/// The coordinates about a point are Cartesian, at the origin the point, and show balls as balls. In doubles: nothing
/// rests on it. Rounds have the result of one point after the other, for any number of threads.
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
      landed = throw_some(seed, dart, dart + batch);
      dart += batch;
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
      fill_gaps_of(open, seed, round, progress, still_open);
      for (auto label = first_new; label < points_.size(); ++label) still_open.push_back(label);
      open = std::move(still_open);
    }
  }

  /// Looks at all cells, for the two that follow.
  void measure(const Progress& progress) {
    const auto cells = [this](std::size_t first, std::size_t last) {
      std::vector<Extent> extents;
      for (auto label = static_cast<std::uint32_t>(first); label < last; ++label)
        extents.push_back(extent_of(cell_of(label)));
      return extents;
    };
    in_parts("measure the net", points_.size(), progress, cells, [this](const std::vector<Extent>& extents) {
      for (const Extent& extent : extents) note(extent);
    });
  }
  [[nodiscard]] double covering_radius() const { return covering_radius_; }
  [[nodiscard]] double separation() const { return separation_; }

  [[nodiscard]] Cell cell_of(std::uint32_t label) const {
    std::vector<Vector<double, m>> around;
    points_.look_about(label, around);
    return cells_.cell(around);
  }

 private:
  static constexpr bool in_rounds = SampledInRounds<Points>;
  struct Extent {
    double farthest_vertex, nearest;
  };
  static Extent extent_of(const Cell& cell) { return {cell.farthest_vertex, cell.nearest}; }
  void note(const Extent& extent) {
    covering_radius_ = std::max(covering_radius_, extent.farthest_vertex);
    separation_ = std::min(separation_, extent.nearest);
  }

  /// Says how many land.
  std::uint32_t throw_some(std::uint64_t seed, std::uint32_t first_dart, std::uint32_t last_dart) {
    std::uint32_t landed = 0;
    if constexpr (in_rounds) {
      using Candidates = std::vector<typename Points::Candidate>;
      points_.begin_round();
      const auto draw = [&](std::size_t first, std::size_t last) {
        Candidates free;
        for (std::size_t at = first; at < last; ++at) {
          CounterRandom random(seed, RandomPurpose::darts, first_dart + static_cast<std::uint32_t>(at), 0);
          if (auto candidate = points_.dart(random)) free.push_back(std::move(*candidate));
        }
        return free;
      };
      in_parts<64>("throw darts", last_dart - first_dart, no_progress(), draw, [&](const Candidates& free) {
        for (const auto& candidate : free) landed += points_.insert(candidate) ? 1U : 0U;
      });
    } else {
      for (std::uint32_t dart = first_dart; dart < last_dart; ++dart) {
        CounterRandom random(seed, RandomPurpose::darts, dart, 0);
        landed += points_.throw_dart(random) ? 1U : 0U;
      }
    }
    return landed;
  }

  /// One round of `fill_gaps` over these cells; adds those with gaps to `still_open`.
  void fill_gaps_of(const std::vector<std::uint32_t>& open, std::uint64_t seed, std::uint32_t round,
                    const Progress& progress, std::vector<std::uint32_t>& still_open) {
    if constexpr (in_rounds) {
      constexpr std::size_t part = 4;
      constexpr std::size_t most_at_a_time = 64 * part;
      for (std::size_t begin = 0; begin < open.size();) {
        if (begin % 1024 < most_at_a_time) progress("fill gaps", begin, open.size());
        // Of so few of all points hardly any two are close.
        const std::size_t length = std::clamp<std::size_t>(points_.size() / 16, part, most_at_a_time);
        const std::size_t end = std::min(open.size(), begin + length);
        points_.begin_round();
        std::size_t next = begin;
        const auto look = [&](std::size_t first, std::size_t last) {
          std::vector<Filling> fillings;
          for (std::size_t at = first; at < last; ++at) fillings.push_back(filling_of(open[begin + at], seed, round));
          return fillings;
        };
        in_parts<part>("fill gaps", end - begin, no_progress(), look, [&](const std::vector<Filling>& fillings) {
          for (const Filling& filling : fillings) {
            const std::uint32_t label = open[next++];
            take(points_.has_new_about(label) ? filling_of(label, seed, round) : filling, label, still_open);
          }
        });
        begin = end;
      }
    } else {
      for (std::size_t at = 0; at < open.size(); ++at) {
        if (at % 1024 == 0) progress("fill gaps", at, open.size());
        const Cell cell = cell_of(open[at]);
        const auto places = places_in_gaps(cell, open[at], seed, round);
        for (const auto& place : places) points_.insert_about(open[at], place);
        if (places.empty()) {
          note(extent_of(cell));
        } else {
          still_open.push_back(open[at]);
        }
      }
    }
  }

  [[nodiscard]] std::vector<Vector<double, m>> places_in_gaps(const Cell& cell, std::uint32_t label, std::uint64_t seed,
                                                              std::uint32_t round) const {
    CounterRandom random(seed, RandomPurpose::gap_filling, label, round);
    return cells_.points_in_gaps(cell, radius_, random);
  }

  /// What is to be put into the gaps of a cell.
  template <class P>
  struct FillingBy {
    Extent extent{};
    bool has_gaps = false;
    std::vector<typename P::Candidate> candidates;
  };
  struct Nothing {
    struct Candidate {};
  };
  using Filling = FillingBy<std::conditional_t<in_rounds, Points, Nothing>>;

  [[nodiscard]] Filling filling_of(std::uint32_t label, std::uint64_t seed, std::uint32_t round) const {
    const Cell cell = cell_of(label);
    const auto places = places_in_gaps(cell, label, seed, round);
    Filling result{extent_of(cell), !places.empty(), {}};
    for (const auto& place : places) {
      if (auto candidate = points_.candidate_about(label, place)) result.candidates.push_back(std::move(*candidate));
    }
    return result;
  }
  void take(const Filling& filling, std::uint32_t label, std::vector<std::uint32_t>& still_open) {
    for (const auto& candidate : filling.candidates) points_.insert(candidate);
    if (filling.has_gaps) {
      still_open.push_back(label);
    } else {
      note(filling.extent);
    }
  }

  Points& points_;
  double radius_;
  VoronoiCells<m> cells_;
  double covering_radius_ = 0;
  double separation_ = std::numeric_limits<double>::infinity();
};

}  // namespace delcert
