#include "kernel/sample/poisson_disk.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/chart/net_grid.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/random/counter_random.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "kernel/stars/approximate_sphere.hpp"
#include "kernel/stars/proposal.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// A gap counts when it exceeds the radius by this factor: more than the slack of `approximately_occupied`, so that
/// its centre can be inserted.
constexpr double clearance = 1 + 0x1p-28;
/// Darts for each ball of the radius that would fit by volume.
constexpr double darts_per_cell = 25;
constexpr int most_rounds = 100;
constexpr double most_points = 4e6;

double ball_volume(int dimension) {
  const std::array<double, 5> volumes{1, 2, 3.14159265358979, 4.18879020478639, 4.93480220054468};
  return volumes[static_cast<std::size_t>(dimension)];
}

template <int m>
class Sampler {
 public:
  /// `sizing`: none if the radius is the same everywhere. It is kept.
  Sampler(const FlatSpace<m>& space, double radius, const TorusSizing<m>* sizing, std::uint64_t seed)
      : space_(space),
        radius_(radius),
        sizing_(sizing),
        outer_radius_(space.is_torus() ? 0 : approximate_double(*space.ball_radius) + 2 * radius_),
        seed_(seed),
        grid_(space.metric, space.is_torus() ? std::nullopt : std::optional(outer_radius_),
              sizing == nullptr ? radius_ : std::sqrt(radius_ * sizing->least()), expected_points()),
        proposal_(space_, radius_) {}

  void throw_darts(const Progress& progress) {
    const auto darts = static_cast<std::size_t>(std::ceil(darts_per_cell * cells()));
    const auto draw = [this](std::size_t first, std::size_t last) {
      std::vector<Candidate> free;
      for (std::size_t dart = first; dart < last; ++dart) {
        CounterRandom random(seed_, RandomPurpose::darts, static_cast<std::uint32_t>(dart), 0);
        const auto x = random_place(random);
        add_if_free({x, radius_at(x)}, free);
      }
      return free;
    };
    in_parts<128>("throw darts", darts, progress, draw, [this](const auto& free) { insert_those_free(free); });
  }

  /// Returns whether a gap was found.
  bool fill_gaps(std::uint32_t round) {
    const auto plain = space_.metric.template on<PlainDouble>();
    simplices_ = proposal_.simplices(grid_.points());
    struct Found {
      bool gap = false;
      std::vector<Candidate> free;
    };
    const auto look = [&](std::size_t first, std::size_t last) {
      Found result;
      for (auto at = static_cast<std::uint32_t>(first); at < last; ++at) {
        std::array<Vector<double, m>, static_cast<std::size_t>(m) + 1> vertices;
        for (std::size_t corner = 0; corner <= m; ++corner) {
          const Lift<m>& vertex = simplices_[at][corner];
          vertices[corner] = grid_.points()[vertex.index];
          for (std::size_t axis = 0; axis < m; ++axis) vertices[corner][axis] += vertex.shift[axis];
        }
        const auto sphere = approximate_sphere<m>(plain, vertices);
        const double gap = std::sqrt(sphere.squared_radius);
        double radius = radius_;
        for (const auto& vertex : vertices) radius = std::min(radius, radius_at(vertex));
        if (!std::isfinite(gap) || gap <= radius * clearance || !is_sampled(sphere.centre)) continue;
        result.gap = true;
        CounterRandom random(seed_, RandomPurpose::gap_filling, at, round);
        add_if_free({random_in_ball(random, sphere.centre, gap - radius * clearance), radius}, result.free);
      }
      return result;
    };
    // All vertices are of the points before; what is inserted changes no index.
    bool found = false;
    in_parts<64>("fill gaps", simplices_.size(), no_progress(), look, [&](const Found& part) {
      found = found || part.gap;
      insert_those_free(part.free);
    });
    return found;
  }

  [[nodiscard]] std::vector<Vector<Rational, m>> net() const { return points_in(grid_.spatial_order()); }

  /// With the triangulation in which gaps were looked for last.
  [[nodiscard]] TriangulatedNet<m> triangulated_net() const {
    const auto order = grid_.spatial_order();
    std::vector<std::uint32_t> new_label(order.size());
    for (std::uint32_t label = 0; label < order.size(); ++label) new_label[order[label]] = label;
    std::vector<std::vector<LiftedSimplex<m>>> relabelled{simplices_};
    for_each_in_parts(simplices_.size(), [&](std::size_t at) {
      LiftedSimplex<m>& simplex = relabelled[0][at];
      for (Lift<m>& vertex : simplex) vertex.index = new_label[vertex.index];
      simplex = canonical<m>(simplex);
    });
    return {points_in(order), in_order<m>(relabelled, order.size())};
  }

 private:
  [[nodiscard]] std::vector<Vector<Rational, m>> points_in(const std::vector<std::uint32_t>& order) const {
    std::vector<Vector<Rational, m>> result(order.size());
    for_each_in_parts(order.size(), [&](std::size_t at) {
      for (std::size_t axis = 0; axis < m; ++axis)
        result[at][axis] = Rational::exactly(grid_.points()[order[at]][axis]);
    });
    return result;
  }
  template <class Work>
  static void for_each_in_parts(std::size_t count, const Work& work) {
    const auto some = [&](std::size_t first, std::size_t last) {
      for (std::size_t at = first; at < last; ++at) work(at);
      return true;
    };
    in_parts<1024>("fill gaps", count, no_progress(), some, [](bool) {});
  }

  static double raised_to_dimension(double x) {
    double result = 1;
    for (int factor = 0; factor < m; ++factor) result *= x;
    return result;
  }

  /// How many balls of the radius fit by volume.
  [[nodiscard]] double cells() const {
    const double volume = space_.is_torus() ? std::sqrt(approximate_double(space_.metric.determinant()))
                                            : ball_volume(m) * raised_to_dimension(outer_radius_);
    const double result = volume / raised_to_dimension(radius_) * mean_density();
    if (!(result <= most_points)) {
      throw Rejection("a net of this radius would have more than " + std::to_string(static_cast<long>(most_points)) +
                      " points, which is the most that is supported");
    }
    return result;
  }
  /// The mean over the space of (greatest radius/radius)^m, about.
  [[nodiscard]] double mean_density() const {
    if (sizing_ == nullptr) return 1;
    constexpr std::uint32_t places = 4096;
    double sum = 0;
    for (std::uint32_t place = 0; place < places; ++place) {
      // Other numbers than those that points are made from.
      CounterRandom random(seed_, RandomPurpose::darts, place, 1);
      sum += raised_to_dimension(radius_ / sizing_->at(random_in_unit_cell(random)));
    }
    return sum / places;
  }
  [[nodiscard]] double radius_at(const Vector<double, m>& x) const {
    return sizing_ == nullptr ? radius_ : sizing_->at(x);
  }
  [[nodiscard]] std::size_t expected_points() const { return static_cast<std::size_t>(cells()) + 16; }

  [[nodiscard]] bool is_sampled(const Vector<double, m>& x) const {
    return space_.is_torus() || pairing(x, x) <= outer_radius_ * outer_radius_;
  }

  Vector<double, m> random_in_unit_cell(CounterRandom& random) const {
    Vector<double, m> x;
    for (double& coordinate : x) coordinate = random.next_unit();
    return x;
  }

  /// Uniformly; where radii vary as often as there are to be points, nearly: what is missing then gaps are filled with.
  Vector<double, m> random_place(CounterRandom& random) const {
    if (!space_.is_torus()) return random_in_ball(random, {}, outer_radius_);
    constexpr int most_draws = 64;
    auto x = random_in_unit_cell(random);
    for (int draw = 1; sizing_ != nullptr && draw < most_draws; ++draw) {
      if (random.next_unit() <= raised_to_dimension(sizing_->least() / sizing_->at(x))) break;
      x = random_in_unit_cell(random);
    }
    return x;
  }

  Vector<double, m> random_in_ball(CounterRandom& random, const Vector<double, m>& centre, double radius) const {
    Vector<double, m> cartesian;
    do {
      for (double& coordinate : cartesian) coordinate = 2 * random.next_unit() - 1;
    } while (pairing(cartesian, cartesian) > 1);
    for (double& coordinate : cartesian) coordinate *= radius;
    return sum(centre, space_.metric.approximate_frame(cartesian));
  }

  /// A point, and how far it has to be from others.
  struct Candidate {
    Vector<double, m> x;
    double radius;
  };
  /// What is inserted stays: what is not free now never will be.
  void add_if_free(Candidate candidate, std::vector<Candidate>& free) const {
    for (double& coordinate : candidate.x) {
      coordinate = on_net_grid(coordinate);
      if (space_.is_torus()) coordinate -= std::floor(coordinate);
    }
    if (!is_sampled(candidate.x) || grid_.approximately_occupied(candidate.x, candidate.radius)) return;
    free.push_back(candidate);
  }
  /// One after the other, in this order.
  void insert_those_free(const std::vector<Candidate>& candidates) {
    for (const Candidate& candidate : candidates) {
      if (!grid_.approximately_occupied(candidate.x, candidate.radius)) grid_.insert(candidate.x);
    }
  }

  const FlatSpace<m>& space_;
  double radius_;  // the greatest
  const TorusSizing<m>* sizing_;
  double outer_radius_;
  std::uint64_t seed_;
  PointGrid<m> grid_;
  GrowingProposal<m> proposal_;
  std::vector<LiftedSimplex<m>> simplices_;
};

template <int m>
void complete(Sampler<m>& sampler, const Progress& progress) {
  sampler.throw_darts(progress);
  for (std::uint32_t round = 0; round < most_rounds; ++round) {
    progress("fill gaps", round, most_rounds);
    if (!sampler.fill_gaps(round)) return;
  }
  throw Rejection("maximal Poisson-disk sampling found gaps for " + std::to_string(most_rounds) + " rounds");
}

}  // namespace

template <int m>
std::vector<Vector<Rational, m>> poisson_disk_net(const FlatSpace<m>& space, const Rational& radius, std::uint64_t seed,
                                                  const Progress& progress) {
  return triangulated_poisson_disk_net<m>(space, radius, seed, progress).points;
}

template <int m>
TriangulatedNet<m> triangulated_poisson_disk_net(const FlatSpace<m>& space, const Rational& radius, std::uint64_t seed,
                                                 const Progress& progress) {
  Sampler<m> sampler(space, approximate_double(radius), nullptr, seed);
  complete<m>(sampler, progress);
  return sampler.triangulated_net();
}

template <int m>
std::vector<Vector<Rational, m>> poisson_disk_net(const FlatSpace<m>& space, const TorusSizing<m>& sizing,
                                                  std::uint64_t seed, const Progress& progress) {
  Sampler<m> sampler(space, sizing.greatest(), &sizing, seed);
  complete<m>(sampler, progress);
  return sampler.net();
}

#define DELCERT_INSTANTIATE(m)                                                                                       \
  template std::vector<Vector<Rational, m>> poisson_disk_net<m>(const FlatSpace<m>&, const Rational&, std::uint64_t, \
                                                                const Progress&);                                    \
  template TriangulatedNet<m> triangulated_poisson_disk_net<m>(const FlatSpace<m>&, const Rational&, std::uint64_t,  \
                                                               const Progress&);                                     \
  template std::vector<Vector<Rational, m>> poisson_disk_net<m>(const FlatSpace<m>&, const TorusSizing<m>&,          \
                                                                std::uint64_t, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
