#include "kernel/sample/separation.hpp"

#include <string>
#include <vector>

#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr long exponent = -20;

/// The squared distance of the sighted point from p_i, or a lower bound of it.
template <int m>
Rational squared_distance(const Atlas<m>& atlas, Label i, const Sighting<m>& other) {
  const PointSet<m>& net = atlas.net();
  if (const auto carried = atlas.carry(i, other, net.exact(label_of<m>(other))))
    return atlas.metric().template on<Rational>().squared_norm(difference(*carried, net.exact(i)));
  const BigInterval::Precision precision(PrecisionBits{256});
  const auto carried = atlas.carry(i, other, net.template coordinates<BigInterval>(label_of<m>(other)));
  const auto offset = difference(carried, net.template coordinates<BigInterval>(i));
  return maximum(atlas.metric().template on<BigInterval>().squared_norm(offset), BigInterval(0)).lower();
}

/// The least squared distance from the labels first … last − 1, in squares of their sampling radii, or 1 if none is
/// less.
template <int m>
Rational least_squared_ratio(const Atlas<m>& atlas, std::size_t first, std::size_t last) {
  Rational least(1);
  std::vector<Sighting<m>> seen;
  const FilterGuard guard;
  const auto metric = atlas.metric().template on<Filter>();
  for (auto index = static_cast<std::uint32_t>(first); index < last; ++index) {
    const Label i(index);
    const Rational& radius = atlas.sampling_radius(i);
    const Filter squared_radius = scalar_from<Filter>(square(radius));
    atlas.sightings(i, approximate_double(radius), seen);
    for (const Sighting<m>& other : seen) {
      if (other.index == index && other.is_unmoved()) continue;
      const auto offset =
          difference(atlas.carry(i, other, atlas.net().enclosure(label_of<m>(other))), atlas.net().enclosure(i));
      if (is_proved(less_equal(squared_radius, metric.squared_norm(offset)))) continue;
      least = minimum(least, squared_distance(atlas, i, other) / square(radius));
      if (least < Rational::power_of_two(2 * exponent))
        throw InputError("labels " + std::to_string(index) + " and " + std::to_string(other.index) +
                         " are points closer than 2^-20 times the sampling radius, or the same");
    }
  }
  return least;
}

}  // namespace

template <int m>
Rational squared_separation(const Atlas<m>& atlas, LabelRange labels, const Progress& progress) {
  Rational least(1);
  in_parts(
      "measure the separation", labels.size(), progress,
      [&](std::size_t first, std::size_t last) {
        return least_squared_ratio<m>(atlas, labels.first + first, labels.first + last);
      },
      [&least](const Rational& found) { least = minimum(least, found); });
  return least;
}

Rational separation_of(const Rational& squared) { return rounded_down(square_root_lower(squared, 40), exponent); }

template <int m>
Rational measure_separation(const Atlas<m>& atlas, const Progress& progress) {
  return separation_of(squared_separation<m>(atlas, all_labels_of(atlas), progress));
}

#define DELCERT_INSTANTIATE(m)                                                           \
  template Rational squared_separation<m>(const Atlas<m>&, LabelRange, const Progress&); \
  template Rational measure_separation<m>(const Atlas<m>&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
