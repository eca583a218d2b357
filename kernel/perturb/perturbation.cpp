#include "kernel/perturb/perturbation.hpp"

#include <algorithm>
#include <string>

#include "kernel/error.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/sample/counter_random.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// The grid is finer than the tolerance, and than the sampling radius, by these powers of two.
constexpr long digits_below_tolerance = 32;
constexpr long digits_below_radius = 40;

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

}  // namespace

template <int m>
Perturbation<m>::Perturbation(const Atlas<m>& atlas, const PerturbationParameters& parameters)
    : atlas_(atlas),
      parameters_(parameters),
      grid_exponent_(grid_exponent_for(atlas, parameters)),
      points_(atlas.net()),
      placed_(atlas.size(), false),
      attempts_(atlas.size(), 0),
      test_(atlas_, points_, placed_, parameters_),
      delaunay_(atlas_, points_, placed_, parameters_) {}

template <int m>
void Perturbation<m>::place_all(const Progress& progress) {
  for (std::uint32_t index = 0; index < atlas_.size(); ++index) {
    if (index % 256 == 0) progress("perturb", index, atlas_.size());
    place(Label(index));
  }
  progress("perturb", atlas_.size(), atlas_.size());
}

template <int m>
void Perturbation<m>::place_anew(std::vector<Label> labels, const Progress& progress) {
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  for (const Label label : labels) placed_[label.value] = false;
  for (std::size_t at = 0; at < labels.size(); ++at) {
    if (at % 256 == 0) progress("repair", at, labels.size());
    place(labels[at]);
  }
}

template <int m>
void Perturbation<m>::place(Label i) {
  const FilterGuard guard;
  test_.prepare(i);
  statistics_.candidates += test_.candidate_count();
  statistics_.most_candidates = std::max<std::uint64_t>(statistics_.most_candidates, test_.candidate_count());
  statistics_.visited += test_.visited();
  const bool chooses = parameters_.choices > 1 || parameters_.clearance > Rational(0);
  std::uint32_t tries = 0;
  if (auto x = chooses ? best_good(i, tries) : first_good(i, tries)) {
    points_.place(i, std::move(*x));
    placed_[i.value] = true;
    ++statistics_.placements;
    statistics_.tries += tries;
    statistics_.most_tries = std::max(statistics_.most_tries, tries);
    return;
  }
  throw Rejection("no good perturbation of label " + std::to_string(i.value) + " in " +
                  std::to_string(parameters_.most_tries) + " tries, with tolerance " +
                  exact_text(parameters_.tolerance) + " and " + std::to_string(test_.candidate_count()) +
                  " candidates");
}

template <int m>
std::optional<Vector<Rational, m>> Perturbation<m>::first_good(Label i, std::uint32_t& tries) {
  while (tries < parameters_.most_tries) {
    ++tries;
    Vector<Rational, m> x = random_position(i, attempts_[i.value]++);
    if (test_.accepts(x)) return x;
  }
  return std::nullopt;
}

template <int m>
std::optional<Vector<Rational, m>> Perturbation<m>::best_good(Label i, std::uint32_t& tries) {
  delaunay_.prepare(i, test_);
  const double enough = approximate_double(parameters_.clearance * atlas_.sampling_radius(i));
  std::optional<Vector<Rational, m>> best;
  double farthest = 0;
  // Tests are dear, so they are for what would be better than the best so far.
  for (std::uint32_t chosen = 0; tries < parameters_.most_tries; ++chosen) {
    if (best && chosen >= parameters_.choices && (farthest >= enough || chosen >= 16 * parameters_.choices)) break;
    ++tries;
    Vector<Rational, m> x = random_position(i, attempts_[i.value]++);
    const double clearance = delaunay_.clearance(x);
    if ((best && clearance <= farthest) || !test_.accepts(x)) continue;
    best = std::move(x);
    farthest = clearance;
  }
  return best;
}

template <int m>
Vector<Rational, m> Perturbation<m>::random_position(Label i, std::uint32_t attempt) const {
  const Vector<Rational, m>& original = atlas_.net().exact(i);
  const Rational radius = parameters_.perturbation * atlas_.sampling_radius(i);
  const Rational step = Rational::power_of_two(grid_exponent_);
  const auto metric = atlas_.metric().template on<Rational>();
  CounterRandom random(parameters_.seed, RandomPurpose::perturbation, i.value, attempt);
  while (true) {
    Vector<Rational, m> x;
    for (std::size_t axis = 0; axis < m; ++axis) {
      // The grid points of a box that holds the ball: first … first + count − 1 steps.
      const Rational half = square_root_upper(square(radius) * atlas_.metric().inverse_diagonal(axis), 32);
      const Integer first = floor_of((original[axis] - half) / step);
      const Integer count = ceiling_of((original[axis] + half) / step) - first + 1;
      const auto bits = static_cast<unsigned>(msb(count)) + 1;
      Integer chosen;
      do {
        chosen = random.next_integer(bits);
      } while (chosen >= count);
      x[axis] = Rational(Integer(first + chosen)) * step;
    }
    if (metric.squared_norm(difference(x, original)) <= square(radius)) return x;
  }
}

#define DELCERT_INSTANTIATE(m) template class Perturbation<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
