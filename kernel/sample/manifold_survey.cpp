#include "kernel/sample/manifold_survey.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "kernel/chart/ambient_grid.hpp"
#include "kernel/random/counter_random.hpp"

namespace delcert {

namespace {

using Place = ManifoldSurvey::Place;
using Coordinates = std::vector<double>;

constexpr std::uint32_t dart_count = 1U << 14U;

double pairing_of(const Coordinates& a, const Coordinates& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}
Coordinates sum_of(Coordinates a, double factor, const Coordinates& b) {
  for (std::size_t axis = 0; axis < a.size(); ++axis) a[axis] += factor * b[axis];
  return a;
}

/// Of the unit ball in ℝ^q.
double ball_volume(std::size_t q) {
  const double half = static_cast<double>(q) / 2;
  return std::pow(std::numbers::pi, half) / std::tgamma(half + 1);
}

class Surveyor {
 public:
  Surveyor(const EmbeddedManifold& manifold, double radius, std::uint64_t seed)
      : n_(manifold.ambient()),
        q_(manifold.codimension()),
        seed_(seed),
        least_distance_(radius * 0x1p-20),
        sampler_(manifold.sampler(radius)) {
    for (const auto& side : manifold.box()) {
      lower_.push_back(approximate_double(side[0]));
      upper_.push_back(approximate_double(side[1]));
    }
  }

  void throw_darts(const Progress& progress) {
    std::vector<std::pair<double, double>> hits;  // how far a dart was from M; the curvature there
    for (std::uint32_t dart = 0; dart < dart_count; ++dart) {
      progress("survey the manifold", dart, dart_count);
      CounterRandom random = numbers(dart);
      const Coordinates start = sampler_->dart(random);
      auto place = place_from(start);
      if (!place) continue;
      const Coordinates way = sum_of(place->x, -1, start);
      hits.emplace_back(std::sqrt(pairing_of(way, way)), place->curvature);
      survey_.places.push_back(*std::move(place));
    }
    measure(std::move(hits));
  }

  void look_around(const std::vector<Coordinates>& places, double radius) {
    constexpr int scales = 8;
    constexpr int tries = 8;
    constexpr std::size_t most_places = 64;
    for (std::size_t at = 0; at < std::min(places.size(), most_places); ++at) {
      CounterRandom random = numbers(dart_count + static_cast<std::uint32_t>(at));
      for (int k = 0; k < scales * tries; ++k) {
        if (auto place = place_from(beside(places[at], std::ldexp(radius, -(k / tries)), random)))
          survey_.places.push_back(*std::move(place));
      }
    }
  }

  /// From where curvature is greatest to where it is greater still.
  void climb() {
    constexpr std::size_t climbers = 16;
    constexpr int steps = 64;
    sort();
    for (std::size_t at = 0; at < std::min(climbers, survey_.places.size()); ++at) {
      Place& place = survey_.places[at];
      CounterRandom random = numbers(2 * dart_count + static_cast<std::uint32_t>(at));
      double step = 0.25 / place.curvature;
      for (int k = 0; k < steps && std::isfinite(step); ++k) {
        auto other = place_from(beside(place.x, step, random));
        if (other && other->curvature > place.curvature) {
          place = *std::move(other);
        } else {
          step *= 0.875;
        }
      }
    }
    sort();
  }

  ManifoldSurvey result() {
    if (survey_.places.empty()) return {};
    const double greatest = survey_.places.front().curvature;
    double extent = 0;
    for (std::size_t axis = 0; axis < n_; ++axis) extent = std::max(extent, upper_[axis] - lower_[axis]);
    survey_.reach = greatest * extent > 1 ? 1 / greatest : extent;
    find_narrow_places();
    return std::move(survey_);
  }

 private:
  /// Two points, on different sheets perhaps.
  struct Pair {
    double quotient = 0;
    Coordinates x, y;
  };

  [[nodiscard]] CounterRandom numbers(std::uint32_t label) const {
    // Other ones than nets and sizing functions are made from.
    return {seed_, RandomPurpose::darts, label, 2};
  }
  [[nodiscard]] Coordinates beside(const Coordinates& x, double step, CounterRandom& random) const {
    Coordinates result = x;
    for (double& coordinate : result) coordinate += step * (2 * random.next_unit() - 1);
    return result;
  }

  std::optional<Place> place_from(Coordinates x) {
    if (!sampler_->project(x, nullptr)) return std::nullopt;
    for (std::size_t axis = 0; axis < n_; ++axis) {
      if (!(x[axis] > lower_[axis] && x[axis] < upper_[axis])) return std::nullopt;
    }
    const double curvature = sampler_->curvature(x);
    if (!std::isfinite(curvature)) return std::nullopt;
    return Place{std::move(x), curvature};
  }

  void sort() {
    std::stable_sort(survey_.places.begin(), survey_.places.end(),
                     [](const Place& a, const Place& b) { return a.curvature > b.curvature; });
  }

  /// Darts that are near M are about equally distributed along it, in a tube of a known thickness.
  void measure(std::vector<std::pair<double, double>> hits) {
    constexpr std::size_t share = 32;
    if (hits.empty()) return;
    std::sort(hits.begin(), hits.end());
    const std::size_t near = std::max<std::size_t>(hits.size() / share, 1);
    double box = 1;
    for (std::size_t axis = 0; axis < n_; ++axis) box *= upper_[axis] - lower_[axis];
    const double tube = box * static_cast<double>(near) / dart_count;
    survey_.volume = tube / (ball_volume(q_) * std::pow(hits[near - 1].first, static_cast<double>(q_)));
    for (std::size_t at = 0; at < near; ++at) survey_.curvatures.push_back(hits[at].second);
    std::sort(survey_.curvatures.begin(), survey_.curvatures.end());
  }

  /// An orthonormal basis of the normals at x; none if there is none to be found.
  std::optional<std::vector<Coordinates>> normals_at(const Coordinates& x) {
    const auto rows = sampler_->normals(x);
    if (!rows) return std::nullopt;
    std::vector<Coordinates> result;
    for (std::size_t b = 0; b < q_; ++b) {
      const auto first = rows->begin() + static_cast<std::ptrdiff_t>(b * n_);
      Coordinates row(first, first + static_cast<std::ptrdiff_t>(n_));
      for (const Coordinates& other : result) row = sum_of(std::move(row), -pairing_of(row, other), other);
      const double length = std::sqrt(pairing_of(row, row));
      if (!(length > 0)) return std::nullopt;
      for (double& coordinate : row) coordinate /= length;
      result.push_back(std::move(row));
    }
    return result;
  }

  /// |y − x|²/(2·height) if the way from x to y is steep enough to lead to another sheet, otherwise infinite. So it is
  /// for points so near that what is seen is how they are rounded.
  [[nodiscard]] double quotient(const std::vector<Coordinates>& normals, const Coordinates& x,
                                const Coordinates& y) const {
    double squared = 0;
    for (std::size_t axis = 0; axis < n_; ++axis) squared += (y[axis] - x[axis]) * (y[axis] - x[axis]);
    double height_squared = 0;
    for (const Coordinates& normal : normals) {
      double height = 0;
      for (std::size_t axis = 0; axis < n_; ++axis) height += normal[axis] * (y[axis] - x[axis]);
      height_squared += height * height;
    }
    if (!(squared > least_distance_ * least_distance_) || !(height_squared > squared / 4))
      return std::numeric_limits<double>::infinity();
    return squared / (2 * std::sqrt(height_squared));
  }

  /// x goes along M towards y, half of the way that there is along M.
  bool approach(Coordinates& x, const Coordinates& y) {
    const auto normals = normals_at(x);
    if (!normals) return false;
    Coordinates way = sum_of(y, -1, x);
    for (const Coordinates& normal : *normals) way = sum_of(std::move(way), -pairing_of(way, normal), normal);
    x = sum_of(std::move(x), 0.5, way);
    return sampler_->project(x, nullptr);
  }

  void find_narrow_places() {
    constexpr std::size_t most_points = 3000;
    constexpr std::size_t most_pairs = 24;
    constexpr int steps = 24;
    // Pairs whose quotients are below the reach so far are at most twice as far apart; before they approach one
    // another twice that.
    const double distance = 4 * survey_.reach;
    AmbientGrid grid(n_, distance);
    std::vector<std::size_t> taken;
    for (std::size_t at = 0; at < survey_.places.size(); at += survey_.places.size() / most_points + 1) {
      grid.insert(survey_.places[at].x.data());
      taken.push_back(at);
    }
    std::vector<Pair> pairs;
    for (const std::size_t at : taken) {
      const Coordinates& x = survey_.places[at].x;
      const auto normals = normals_at(x);
      if (!normals) continue;
      Pair best{std::numeric_limits<double>::infinity(), x, {}};
      grid.visit(x.data(), distance, [&](std::uint32_t other, double) {
        const Coordinates& y = survey_.places[taken[other]].x;
        const double found = quotient(*normals, x, y);
        if (found < best.quotient) {
          best.quotient = found;
          best.y = y;
        }
        return false;
      });
      if (!best.y.empty()) pairs.push_back(std::move(best));
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.quotient < b.quotient; });
    if (pairs.size() > most_pairs) pairs.resize(most_pairs);
    for (Pair& pair : pairs) {
      double least = pair.quotient;
      for (int step = 0; step < steps && approach(pair.x, pair.y) && approach(pair.y, pair.x); ++step) {
        if (const auto normals = normals_at(pair.x)) least = std::min(least, quotient(*normals, pair.x, pair.y));
      }
      if (least < survey_.reach) {
        survey_.narrow.push_back(pair.x);
        survey_.narrow.push_back(pair.y);
      }
      pair.quotient = least;
    }
    for (const Pair& pair : pairs) survey_.reach = std::min(survey_.reach, pair.quotient);
  }

  std::size_t n_;
  std::size_t q_;
  std::uint64_t seed_;
  double least_distance_;
  std::unique_ptr<ManifoldSampler> sampler_;
  Coordinates lower_, upper_;
  ManifoldSurvey survey_;
};

}  // namespace

ManifoldSurvey survey_manifold(const EmbeddedManifold& manifold, double radius, const std::vector<Coordinates>& around,
                               std::uint64_t seed, const Progress& progress) {
  Surveyor surveyor(manifold, radius, seed);
  surveyor.throw_darts(progress);
  surveyor.look_around(around, radius);
  surveyor.climb();
  return surveyor.result();
}

}  // namespace delcert
