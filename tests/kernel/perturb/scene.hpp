#pragma once

#include "kernel/perturb/candidates.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

// A moment of the algorithm: some points are placed, one is to be placed; and what it is tested against, the slow way.
namespace delcert::test {

/// |d − R| > t for rationals, from the definition: d > R + t or d < R − t, by squaring.
inline bool is_exactly_farther(const Rational& squared_distance, const Rational& squared_radius,
                               const Rational& squared_tolerance) {
  // d > R + t: d² − R² − t² > 2Rt. d < R − t: R > t and R² + t² − d² > 2Rt.
  const Rational twice = Rational(4) * squared_radius * squared_tolerance;
  const Rational outside = squared_distance - squared_radius - squared_tolerance;
  const Rational inside = squared_radius + squared_tolerance - squared_distance;
  return (outside > Rational(0) && square(outside) > twice) ||
         (squared_radius > squared_tolerance && inside > Rational(0) && square(inside) > twice);
}

template <int m>
struct Scene {
  FlatSpace<m> space;
  ExactPoints<m> net;
  ExactPoints<m> points;  // placed ones displaced, others as in the net
  PlacedLabels placed;
  Rational sampling_radius;
  PerturbationParameters parameters;

  [[nodiscard]] FlatAtlas<m> atlas() const { return FlatAtlas<m>(space, PointSet<m>(net), sampling_radius); }
  [[nodiscard]] Rational tolerance() const { return parameters.tolerance * sampling_radius; }

  /// The lifts that candidates of i may use.
  [[nodiscard]] Lifts<m> available(std::uint32_t i) const {
    const bool pruned = parameters.candidates == CandidateRule::pruned;
    const Rational reach =
        (pruned ? parameters.edge_bound + parameters.perturbation : Rational(5) + ratio(3, 2) * parameters.separation) *
        sampling_radius;
    const auto& measured = pruned ? points : net;
    Lifts<m> result;
    for (const auto& lift : lifts_within<m>(space, measured, net[i], reach)) {
      if (lift.index == i || (pruned && placed[lift.index] == 0)) continue;
      if (squared_distance<m>(space, at<m>(measured, lift), net[i]) == square(reach)) continue;
      result.push_back(lift);
    }
    return result;
  }

  /// The candidates of label i from their definition.
  [[nodiscard]] std::vector<Lifts<m>> candidates(std::uint32_t i) const {
    const bool pruned = parameters.candidates == CandidateRule::pruned;
    const auto lifts = available(i);
    std::vector<Lifts<m>> result;
    Lifts<m> set;
    const auto extend = [&](const auto& self, std::size_t from) -> void {
      const std::size_t least = parameters.candidates == CandidateRule::printed ? m + 1 : 2;
      if (set.size() >= least && is_candidate(i, set)) result.push_back(set);
      if (set.size() == m + 1) return;
      for (std::size_t next = from; next < lifts.size(); ++next) {
        const auto is_short = [&](const Lift<m>& other) {
          return squared_distance<m>(space, at<m>(points, other), at<m>(points, lifts[next])) <
                 square(parameters.edge_bound * sampling_radius);
        };
        if (pruned && !std::all_of(set.begin(), set.end(), is_short)) continue;
        set.push_back(lifts[next]);
        self(self, next + 1);
        set.pop_back();
      }
    };
    extend(extend, 0);
    std::sort(result.begin(), result.end());
    return result;
  }

  [[nodiscard]] std::optional<Ball<m>> ball(const Lifts<m>& set) const {
    return ball_of_simplex<m>(space, all_at<m>(points, std::span<const Lift<m>>(set)));
  }

  /// Non-degenerate, small (if pruned), and its sphere within reach of some perturbation.
  [[nodiscard]] bool is_candidate(std::uint32_t i, const Lifts<m>& set) const {
    const auto sphere = ball(set);
    if (!sphere) return false;
    if (parameters.candidates == CandidateRule::pruned &&
        sphere->squared_radius >= square(parameters.circumradius_bound * sampling_radius)) {
      return false;
    }
    const Rational reach = (parameters.perturbation + parameters.tolerance) * sampling_radius;
    return !is_exactly_farther(squared_distance<m>(space, net[i], sphere->centre), sphere->squared_radius,
                               square(reach));
  }

  [[nodiscard]] bool is_good(const std::vector<Lifts<m>>& sets, const Vector<Rational, m>& x) const {
    return std::all_of(sets.begin(), sets.end(), [&](const Lifts<m>& set) {
      const auto sphere = ball(set);
      return is_exactly_farther(squared_distance<m>(space, x, sphere->centre), sphere->squared_radius,
                                square(tolerance()));
    });
  }
};

/// Random points of which every third is not yet placed; those placed are up to ρ₀ε away from the net.
template <int m>
Scene<m> any_scene(const FlatSpace<m>& space, ExactPoints<m> net, const Rational& sampling_radius,
                   const Rational& tolerance, std::uint64_t seed) {
  Scene<m> scene;
  scene.space = space;
  scene.net = std::move(net);
  scene.points = scene.net;
  scene.sampling_radius = sampling_radius;
  scene.parameters.separation = Rational(1);
  scene.parameters.perturbation = ratio(1, 4);
  scene.parameters.tolerance = tolerance;
  scene.parameters.edge_bound = ratio(5, 2);
  scene.parameters.circumradius_bound = Rational(2);
  const auto offsets = random_points<m>(scene.net.size(), seed, 16, Rational(-1), Rational(2));
  Rational total(0);
  for (const auto& row : space.metric.gram()) {
    for (const Rational& entry : row) total += absolute(entry);
  }
  // No offset is longer than the root of the total.
  const Rational step = scene.parameters.perturbation * sampling_radius / square_root_upper(total, 20);
  for (std::size_t index = 0; index < scene.net.size(); ++index) {
    scene.placed.push_back(index % 3 != 2 ? 1 : 0);
    if (scene.placed.back() == 0) continue;
    scene.points[index] = sum(scene.net[index], scaled(step, offsets[index]));
  }
  return scene;
}

}  // namespace delcert::test
