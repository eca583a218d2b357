#include "kernel/sample/space_form_separation.hpp"

#include <string>

#include "kernel/parallel/parts.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr long exponent = -20;

/// A lower bound of the squared distance of the sighted point from p_i.
template <int m>
Rational squared_distance_from_below(const SpaceFormAtlas<m>& atlas, Label i, const Sighting<m>& other) {
  const BigInterval::Precision precision(PrecisionBits{256});
  const auto offset = atlas.carry(i, other, Vector<BigInterval, m>{});
  return maximum(atlas.metric().template on<BigInterval>().squared_norm(offset), BigInterval(0)).lower();
}

/// The least squared distance from the labels first … last − 1, or that of ε if none is less.
template <int m>
Rational least_squared_distance(const SpaceFormAtlas<m>& atlas, std::size_t first, std::size_t last) {
  const Rational squared_radius = square(atlas.sampling_radius());
  const double distance = approximate_double(atlas.sampling_radius());
  Rational least = squared_radius;
  std::vector<Sighting<m>> seen;
  const FilterGuard guard;
  const auto metric = atlas.metric().template on<Filter>();
  const Filter enclosed_square = scalar_from<Filter>(squared_radius);
  for (auto index = static_cast<std::uint32_t>(first); index < last; ++index) {
    const Label i(index);
    atlas.sightings(i, distance, seen);
    for (const Sighting<m>& other : seen) {
      if (other.index == index && other.shift == Shift<m>{}) continue;
      const Filter squared = metric.squared_norm(atlas.carry(i, other, Vector<Filter, m>{}));
      if (is_proved(less_equal(enclosed_square, squared))) continue;
      least = minimum(least, squared_distance_from_below(atlas, i, other));
      if (least < squared_radius * Rational::power_of_two(2 * exponent))
        throw InputError("labels " + std::to_string(index) + " and " + std::to_string(other.index) +
                         " are points closer than 2^-20 times the sampling radius, or the same");
    }
  }
  return least;
}

}  // namespace

template <int m>
Rational measure_separation(const SpaceFormAtlas<m>& atlas, const Progress& progress) {
  const Rational squared_radius = square(atlas.sampling_radius());
  Rational least = squared_radius;
  in_parts(
      "measure the separation", atlas.size(), progress,
      [&](std::size_t first, std::size_t last) { return least_squared_distance<m>(atlas, first, last); },
      [&least](const Rational& found) { least = minimum(least, found); });
  return rounded_down(square_root_lower(least / squared_radius, 40), exponent);
}

template Rational measure_separation<2>(const SpaceFormAtlas<2>&, const Progress&);
template Rational measure_separation<3>(const SpaceFormAtlas<3>&, const Progress&);

}  // namespace delcert
