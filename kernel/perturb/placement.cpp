#include "kernel/perturb/placement.hpp"

#include <algorithm>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/parallel/spares.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The grid is finer than the tolerance, and than the sampling radius, by these powers of two.
constexpr long digits_below_tolerance = 32;
constexpr long digits_below_radius = 40;

/// Placing takes long, and classes are small: of fewer labels than this, each is a part of its own, so that no thread
/// waits for another that still has several of them.
constexpr std::size_t labels_in_a_part = 4;
constexpr std::size_t few_labels = 64;

/// A step of the grid in frame coordinates, whatever the length of the frame's vectors: a step of 2^e in one
/// coordinate is a length 2^e·√G_aa.
template <int m>
long grid_exponent_for(const Atlas<m>& atlas, const PerturbationParameters& parameters) {
  Rational least = atlas.sampling_radius(Label(0));
  for (std::uint32_t index = 1; index < atlas.size(); ++index) {
    least = minimum(least, atlas.sampling_radius(Label(index)));
  }
  Rational longest(1);
  for (std::size_t axis = 0; axis < m; ++axis) longest = maximum(longest, atlas.metric().gram()[axis][axis]);
  const long radius = binary_exponent(least) - binary_exponent(longest) / 2 - 1;
  if (is_proved(is_zero(parameters.tolerance))) return radius - digits_below_radius;
  return std::min(radius - digits_below_radius,
                  radius + binary_exponent(parameters.tolerance) - digits_below_tolerance);
}

bool chooses(const PerturbationParameters& parameters) {
  return parameters.choices > 1 || parameters.clearance > Rational(0);
}

}  // namespace

PerturbationStatistics& PerturbationStatistics::operator+=(const PerturbationStatistics& other) {
  placements += other.placements;
  tries += other.tries;
  most_tries = std::max(most_tries, other.most_tries);
  candidates += other.candidates;
  most_candidates = std::max(most_candidates, other.most_candidates);
  visited += other.visited;
  return *this;
}

template <int m>
PlacedPoints<m>::PlacedPoints(const Atlas<m>& atlas, const PerturbationParameters& parameters)
    : points(atlas.net()),
      placed(atlas.size(), 0),
      attempts(atlas.size(), 0),
      grid_exponent(grid_exponent_for(atlas, parameters)) {}

template <int m>
Placement<m>::Placement(const Atlas<m>& atlas, const PerturbationParameters& parameters, PlacedPoints<m>& state)
    : atlas_(atlas),
      parameters_(parameters),
      state_(state),
      metric_([&] {
        const FilterGuard guard;
        return atlas.metric().template on<Filter>();
      }()),
      test_(atlas, state.points, state.placed, parameters),
      delaunay_(parameters) {
  if (chooses(parameters)) test_.look_around(reach_of_delaunay_candidates(parameters));
}

template <int m>
Rational Placement<m>::reach(const PerturbationParameters& parameters) {
  const Rational reach = reach_of_candidates(parameters);
  return chooses(parameters) ? maximum(reach, reach_of_delaunay_candidates(parameters)) : reach;
}

template <int m>
void Placement<m>::place(Label i) {
  const FilterGuard guard;
  test_.prepare(i);
  statistics_.candidates += test_.candidate_count();
  statistics_.most_candidates = std::max<std::uint64_t>(statistics_.most_candidates, test_.candidate_count());
  statistics_.visited += test_.visited();
  if (unit_ != atlas_.sampling_radius(i)) {
    unit_ = atlas_.sampling_radius(i);
    radius_ = parameters_.perturbation * unit_;
  }
  if (!ball_) {
    ball_.emplace(atlas_.metric(), metric_, atlas_.net().exact(i), radius_, state_.grid_exponent);
  } else {
    ball_->move_to(atlas_.net().exact(i), radius_);
  }
  GridBall<m>& ball = *ball_;
  std::uint32_t tries = 0;
  if (auto x = chooses(parameters_) ? best_good(i, ball, tries) : first_good(i, ball, tries)) {
    state_.points.place(i, std::move(*x));
    state_.placed[i.value] = 1;
    ++statistics_.placements;
    statistics_.tries += tries;
    statistics_.most_tries = std::max(statistics_.most_tries, tries);
    return;
  }
  throw Rejection("no good perturbation of label " + std::to_string(i.value + state_.names_begin) + " in " +
                  std::to_string(parameters_.most_tries) + " tries, with tolerance " +
                  exact_text(parameters_.tolerance) + " and " + std::to_string(test_.candidate_count()) +
                  " candidates");
}

template <int m>
std::optional<Vector<Rational, m>> Placement<m>::first_good(Label i, GridBall<m>& ball, std::uint32_t& tries) {
  const auto exactly = [&ball] { return ball.exact(); };
  while (tries < parameters_.most_tries) {
    ++tries;
    draw(i, state_.attempts[i.value]++, ball);
    if (test_.accepts(ball.enclosure(), exactly)) return ball.exact();
  }
  return std::nullopt;
}

template <int m>
std::optional<Vector<Rational, m>> Placement<m>::best_good(Label i, GridBall<m>& ball, std::uint32_t& tries) {
  delaunay_.prepare(atlas_.sampling_radius(i), test_);
  const double enough = approximate_double(parameters_.clearance * atlas_.sampling_radius(i));
  // A test takes much longer than a draw: the farthest of the first positions are tested first, and of those that
  // follow only what would be better.
  const auto exactly = [&ball] { return ball.exact(); };
  struct Drawn {
    std::uint32_t attempt;
    double clearance;
  };
  const auto draw_next = [&] {
    const std::uint32_t attempt = state_.attempts[i.value]++;
    ++tries;
    draw(i, attempt, ball);
    return Drawn{attempt, delaunay_.clearance(ball.enclosure())};
  };
  std::optional<Vector<Rational, m>> best;
  double farthest = 0;
  const auto takes = [&](const Drawn& position) {
    if (!test_.accepts(ball.enclosure(), exactly)) return false;
    best = ball.exact();
    farthest = position.clearance;
    return true;
  };
  const auto draws_and_takes = [&](const Drawn& position) {
    draw(i, position.attempt, ball);
    return takes(position);
  };
  std::vector<Drawn> drawn;
  while (drawn.size() < parameters_.choices && tries < parameters_.most_tries) drawn.push_back(draw_next());
  const auto is_nearer = [](const Drawn& a, const Drawn& b) { return a.clearance < b.clearance; };
  // The first of the farthest, which is good nearly always; so the others are not put in order before.
  const auto first = std::max_element(drawn.begin(), drawn.end(), is_nearer);
  if (first != drawn.end() && !draws_and_takes(*first)) {
    std::rotate(drawn.begin(), first, first + 1);
    std::stable_sort(drawn.begin() + 1, drawn.end(), [&](const Drawn& a, const Drawn& b) { return is_nearer(b, a); });
    (void)std::any_of(drawn.begin() + 1, drawn.end(), draws_and_takes);
  }
  for (auto chosen = drawn.size(); tries < parameters_.most_tries; ++chosen) {
    if (best && (farthest >= enough || chosen >= 16 * std::size_t{parameters_.choices})) break;
    const Drawn position = draw_next();
    if (best && position.clearance <= farthest) continue;
    (void)takes(position);
  }
  return best;
}

template <int m>
void Placement<m>::draw(Label i, std::uint32_t attempt, GridBall<m>& ball) const {
  CounterRandom random(parameters_.seed, RandomPurpose::perturbation, i.value + state_.names_begin, attempt);
  ball.draw(random);
}

template <int m>
PerturbationStatistics place_in_parallel(const Atlas<m>& atlas, const PerturbationParameters& parameters,
                                         PlacedPoints<m>& state, const std::vector<Label>& labels,
                                         std::string_view stage, const Progress& progress) {
  PerturbationStatistics result;
  Spares<Placement<m>> placements;
  const auto place_some = [&](std::size_t first, std::size_t last) {
    return placements.with([&] { return std::make_unique<Placement<m>>(atlas, parameters, state); },
                           [&](Placement<m>& placement) {
                             for (std::size_t at = first; at < last; ++at) placement.place(labels[at]);
                             return placement.take_statistics();
                           });
  };
  const auto take = [&](const PerturbationStatistics& found) { result += found; };
  if (labels.size() < few_labels) {
    in_parts<1>(stage, labels.size(), progress, place_some, take);
  } else {
    in_parts<labels_in_a_part>(stage, labels.size(), progress, place_some, take);
  }
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                                        \
  template struct PlacedPoints<m>;                                                                                    \
  template class Placement<m>;                                                                                        \
  template PerturbationStatistics place_in_parallel<m>(const Atlas<m>&, const PerturbationParameters&,                \
                                                       PlacedPoints<m>&, const std::vector<Label>&, std::string_view, \
                                                       const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
