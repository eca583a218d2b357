#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "kernel/chart/atlas.hpp"

namespace delcert {

/// The sampling radii of labels as parts of the greatest of them: u_i = ε_i/max ε. Lengths that are claimed of all
/// labels count u_i times at label i.
class LengthUnits {
 public:
  /// Throws std::invalid_argument unless these ratios are doubles.
  template <int m>
  explicit LengthUnits(const Atlas<m>& atlas) {
    const Rational* greatest = &atlas.sampling_radius(Label(0));
    bool vary = false;
    for (std::uint32_t index = 1; index < atlas.size(); ++index) {
      const Rational& radius = atlas.sampling_radius(Label(index));
      if (radius == *greatest) continue;
      vary = true;
      if (*greatest < radius) greatest = &radius;
    }
    for (std::uint32_t index = 0; vary && index < atlas.size(); ++index) {
      const Rational unit = atlas.sampling_radius(Label(index)) / *greatest;
      units_.push_back(approximate_double(unit));
      if (Rational::exactly(units_.back()) != unit)
        throw std::invalid_argument("a sampling radius is no double times the greatest");
    }
  }

  /// Whether they are not all 1.
  [[nodiscard]] bool vary() const { return !units_.empty(); }
  [[nodiscard]] double of(Label i) const { return units_.empty() ? 1 : units_[i.value]; }
  /// A length at label i in units: not greater, or not less, than it is.
  [[nodiscard]] double lower(Label i, double length) const { return quotient(i, length, -infinity); }
  [[nodiscard]] double upper(Label i, double length) const { return quotient(i, length, infinity); }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  [[nodiscard]] double quotient(Label i, double length, double towards) const {
    return of(i) == 1 ? length : std::nextafter(length / of(i), towards);
  }

  std::vector<double> units_;
};

}  // namespace delcert
