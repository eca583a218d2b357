#include "kernel/sample/space_form_net.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "kernel/number/simple_fraction.hpp"
#include "kernel/sample/voronoi_cells.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::uint32_t batch = 4096;
/// Darts are thrown until fewer than one in this many lands.
constexpr std::uint32_t worth_throwing = 20;
constexpr std::uint32_t most_rounds = 200;
/// Of how many radii about a point others are looked at: more than 2, the less the quicker.
constexpr double reach = 2.25;

void require_radius(const SpaceForm& form, const Rational& radius) {
  if (radius <= Rational(0)) throw InputError("the radius of a net is above 0");
  if (Rational(3) * radius > form.injectivity_radius.lower)
    throw Rejection(form.description.name +
                    ": the radius of a net is at most a third of the injectivity radius: take at most " +
                    exact_text(simple_fraction_at_most(form.injectivity_radius.lower / Rational(3))));
}

/// A net in the making.
template <int m>
class Sampling {
 public:
  Sampling(const SpaceForm& form, const Rational& radius)
      : radius_(approximate_double(radius)),
        cells_(form.form().curvature(), reach * radius_),
        points_(form, reach * radius_) {}

  void take(const std::vector<Vector<Rational, m>>& centres) {
    for (const auto& centre : centres) {
      Vector<double, m> coordinates;
      for (std::size_t axis = 0; axis < m; ++axis) coordinates[axis] = approximate_double(centre[axis]);
      points_.insert(points_.domain().reduced(points_.domain().point(coordinates)), 0);
    }
  }

  void throw_darts(std::uint64_t seed, const Progress& progress) {
    std::uint32_t dart = 0;
    std::uint32_t landed = batch;
    while (landed * worth_throwing >= batch) {
      progress("throw darts", points_.size(), points_.size());
      landed = 0;
      for (const std::uint32_t end = dart + batch; dart < end; ++dart) {
        CounterRandom random(seed, RandomPurpose::darts, dart, 0);
        if (points_.insert(points_.domain().random_point(random), radius_)) ++landed;
      }
    }
  }

  void fill_gaps(std::uint64_t seed, const Progress& progress) {
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
        const auto cell = cell_of(open[at]);
        CounterRandom random(seed, RandomPurpose::gap_filling, open[at], round);
        const auto places = cells_.points_in_gaps(cell, radius_, random);
        for (const auto& place : places) points_.insert(points_.at(open[at], place), radius_);
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

  void measure() {
    for (std::uint32_t label = 0; label < points_.size(); ++label) note(cell_of(label));
  }

  [[nodiscard]] std::vector<Vector<Rational, m>> relaxed(const Progress& progress) {
    std::vector<Vector<Rational, m>> result;
    for (std::uint32_t label = 0; label < points_.size(); ++label) {
      if (label % 1024 == 0) progress("relax", label, points_.size());
      const auto moved = points_.at(label, VoronoiCells<m>::mass_centre(cell_of(label)));
      Vector<Rational, m> centre;
      for (std::size_t axis = 0; axis < m; ++axis) centre[axis] = Rational::exactly(moved[axis]);
      result.push_back(std::move(centre));
    }
    return result;
  }

  [[nodiscard]] SpaceFormNet<m> net() const { return {points_.ordered(), covering_radius_, separation_}; }

 private:
  using Cell = typename VoronoiCells<m>::Cell;

  [[nodiscard]] Cell cell_of(std::uint32_t label) {
    points_.look_about(label, around_);
    return cells_.cell(around_);
  }
  void note(const Cell& cell) {
    covering_radius_ = std::max(covering_radius_, cell.farthest_vertex);
    separation_ = std::min(separation_, cell.nearest);
  }

  double radius_;
  VoronoiCells<m> cells_;
  SpaceFormPoints<m> points_;
  std::vector<Vector<double, m>> around_;
  double covering_radius_ = 0;
  double separation_ = std::numeric_limits<double>::infinity();
};

}  // namespace

template <int m>
SpaceFormNet<m> space_form_net(const SpaceForm& form, const Rational& radius, std::uint64_t seed,
                               const Progress& progress) {
  require_radius(form, radius);
  Sampling<m> sampling(form, radius);
  sampling.throw_darts(seed, progress);
  sampling.fill_gaps(seed, progress);
  return sampling.net();
}

template <int m>
SpaceFormNet<m> measured_net(const SpaceForm& form, const std::vector<Vector<Rational, m>>& centres,
                             const Rational& radius) {
  require_radius(form, radius);
  Sampling<m> sampling(form, radius);
  sampling.take(centres);
  sampling.measure();
  return sampling.net();
}

template <int m>
SpaceFormNet<m> relaxed_net(const SpaceForm& form, const std::vector<Vector<Rational, m>>& centres,
                            const Rational& radius, std::uint32_t steps, const Progress& progress) {
  require_radius(form, radius);
  auto moved = centres;
  for (std::uint32_t step = 0; step < steps; ++step) {
    Sampling<m> sampling(form, radius);
    sampling.take(moved);
    moved = sampling.relaxed(progress);
  }
  return measured_net<m>(form, moved, radius);
}

#define DELCERT_INSTANTIATE(m)                                                                                        \
  template SpaceFormNet<m> space_form_net<m>(const SpaceForm&, const Rational&, std::uint64_t, const Progress&);      \
  template SpaceFormNet<m> measured_net<m>(const SpaceForm&, const std::vector<Vector<Rational, m>>&,                 \
                                           const Rational&);                                                          \
  template SpaceFormNet<m> relaxed_net<m>(const SpaceForm&, const std::vector<Vector<Rational, m>>&, const Rational&, \
                                          std::uint32_t, const Progress&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
