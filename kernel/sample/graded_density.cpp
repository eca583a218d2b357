#include "kernel/sample/graded_density.hpp"

#include <cmath>
#include <string>

#include "kernel/parallel/parts.hpp"
#include "kernel/sample/covering.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// ε is rounded up to this many binary digits, ε₀ to a multiple of 2^variation_exponent.
constexpr long radius_digits = 30;
constexpr long variation_exponent = -20;
constexpr int patch_factor = 9;

/// Two units, of which the first is the greater one. Units have few digits, so that products of them are exact.
struct Ratio {
  double greater = 1, lesser = 1;
  [[nodiscard]] bool exceeds(const Ratio& other) const { return greater * other.lesser > other.greater * lesser; }
};

template <int m>
class Variation {
 public:
  Variation(const FlatSpace<m>& space, const PointSet<m>& net, const std::vector<double>& units, double usual)
      : net_(net), units_(units), grid_(space.metric, space.box_radius(), usual, net.size()) {
    for (const auto& point : net.approximate_all()) grid_.insert(point);
  }

  /// Of the units of two lifts that are closer than the greater of both times `reach`, or little farther.
  [[nodiscard]] Ratio greatest(double reach, const Progress& progress) const {
    Ratio result;
    in_parts(
        "compare radii", net_.size(), progress,
        [&](std::size_t first, std::size_t last) {
          Ratio here;
          std::vector<Lift<m>> near;
          for (auto index = static_cast<std::uint32_t>(first); index < last; ++index) {
            near.clear();
            grid_.near(net_.approximate(Label(index)), reach * units_[index], near);
            for (const Lift<m>& lift : near) {
              const Ratio found{units_[index], units_[lift.index]};
              if (found.exceeds(here)) here = found;
            }
          }
          return here;
        },
        [&result](const Ratio& found) {
          if (found.exceeds(result)) result = found;
        });
    return result;
  }

 private:
  const PointSet<m>& net_;
  const std::vector<double>& units_;
  PointGrid<m> grid_;
};

Rational a_little_more(const Rational& x) {
  const long digit = binary_exponent(x) - radius_digits;
  return rounded_up(x, digit) + Rational::power_of_two(digit);
}

}  // namespace

template <int m>
GradedDensity<m> measure_graded_density(const FlatSpace<m>& space, const PointSet<m>& net,
                                        const SamplingRadii& proportions, const Progress& progress) {
  progress("measure density", 0, 1);
  if (net.size() <= m) throw Rejection("a net needs more than " + std::to_string(m) + " points");
  const double usual = approximate_double(proportions.greatest());
  Covering<m> covering = cover_net<m>(space, net, usual, proportions.units());
  progress("measure density", 1, 1);
  GradedDensity<m> result{proportions.scaled_to(a_little_more(covering.radius_upper)), Rational(0),
                          std::move(covering.simplices)};
  if (!proportions.vary()) return result;
  const Variation<m> variation(space, net, proportions.units(), usual * middle_unit(proportions.units()));
  // More variation asks for larger radii, and larger radii compare more points: upwards until nothing changes.
  while (true) {
    const Rational factor = Rational(1) + result.radius_variation;
    const Rational greatest = a_little_more(factor * covering.radius_upper);
    result.radii = proportions.scaled_to(greatest);
    const double reach = approximate_double(Rational(patch_factor) * factor * greatest) * (1 + 0x1p-40);
    const Ratio found = variation.greatest(reach, progress);
    const Rational needed = rounded_up(Rational::exactly(found.greater) / Rational::exactly(found.lesser) - Rational(1),
                                       variation_exponent);
    if (needed <= result.radius_variation) return result;
    if (needed > Rational(1))
      throw Rejection(
          "radii vary too much: of two points in a patch one has more than twice the radius of the other; "
          "take cones of slope 1/64 or less");
    result.radius_variation = needed;
  }
}

#define DELCERT_INSTANTIATE(m)                                                                                       \
  template GradedDensity<m> measure_graded_density<m>(const FlatSpace<m>&, const PointSet<m>&, const SamplingRadii&, \
                                                      const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
