#include "kernel/sample/metric_field_separation.hpp"

#include <string>

#include "support/error.hpp"

namespace delcert {

namespace {

constexpr long exponent = -20;

}  // namespace

template <int m>
Rational measure_separation(const MetricFieldAtlas<m>& atlas) {
  const Rational squared_radius = square(atlas.sampling_radius());
  const double distance = approximate_double(atlas.sampling_radius()) * (1 + 0x1p-40);
  const auto exact = atlas.metric().template on<Rational>();
  Rational least = squared_radius;
  std::vector<Sighting<m>> seen;
  const FilterGuard guard;
  const auto metric = atlas.metric().template on<Filter>();
  Filter enclosed_least = scalar_from<Filter>(least);
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const Label i(index);
    atlas.sightings(i, distance, seen);
    for (const Sighting<m>& other : seen) {
      if (other.index == index && other.shift == Shift<m>{}) continue;
      const Filter squared = metric.squared_norm(atlas.carry(i, other, Vector<Filter, m>{}));
      if (is_proved(less_equal(enclosed_least, squared))) continue;
      least = minimum(least, exact.squared_norm(atlas.carry(i, other, Vector<Rational, m>{})));
      enclosed_least = scalar_from<Filter>(least);
      if (least < squared_radius * Rational::power_of_two(2 * exponent))
        throw InputError("labels " + std::to_string(index) + " and " + std::to_string(other.index) +
                         " are points closer than 2^-20 times the sampling radius, or the same");
    }
  }
  return rounded_down(square_root_lower(least / squared_radius, 40), exponent);
}

template Rational measure_separation<2>(const MetricFieldAtlas<2>&);
template Rational measure_separation<3>(const MetricFieldAtlas<3>&);

}  // namespace delcert
