#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// The sampling radii of labels: ε_i = u_i·ε, with u_i ≤ 1 doubles of few digits. Claimed lengths are multiples of ε_i:
/// at label i they count u_i times.
class SamplingRadii {
 public:
  /// All are the same.
  SamplingRadii(Rational radius) : greatest_(std::move(radius)) {}  // NOLINT(google-explicit-constructor)
  /// Of these lengths, each a little less than it is: in 12 binary digits as a part of the greatest.
  explicit SamplingRadii(const std::vector<double>& lengths) {
    double greatest = 0;
    for (const double length : lengths) greatest = std::max(greatest, length);
    greatest_ = Rational::exactly(rounded_down_double(greatest));
    for (const double length : lengths)
      units_.push_back(std::min(rounded_down_double(length / approximate_double(greatest_)), 1.0));
    for (const double unit : units_) radii_.push_back(greatest_ * Rational::exactly(unit));
    if (std::all_of(units_.begin(), units_.end(), [](double unit) { return unit == 1; })) {
      units_.clear();
      radii_.clear();
    }
  }

  /// In the same proportions with another greatest one.
  [[nodiscard]] SamplingRadii scaled_to(Rational greatest) const {
    SamplingRadii result(std::move(greatest));
    result.units_ = units_;
    for (const double unit : units_) result.radii_.push_back(result.greatest_ * Rational::exactly(unit));
    return result;
  }

  /// ε.
  [[nodiscard]] const Rational& greatest() const { return greatest_; }
  [[nodiscard]] const Rational& of(std::size_t label) const { return radii_.empty() ? greatest_ : radii_[label]; }
  [[nodiscard]] bool vary() const { return !units_.empty(); }
  [[nodiscard]] double unit_of(std::size_t label) const { return units_.empty() ? 1 : units_[label]; }
  [[nodiscard]] double least_unit() const {
    return units_.empty() ? 1 : *std::min_element(units_.begin(), units_.end());
  }
  /// u of each label; empty: 1.
  [[nodiscard]] const std::vector<double>& units() const { return units_; }

 private:
  static double rounded_down_double(double x) {
    constexpr int digits = 12;
    if (x == 0) return 0;
    const int exponent = std::ilogb(x) - digits + 1;
    return std::ldexp(std::floor(std::ldexp(x, -exponent)), exponent);
  }

  Rational greatest_;
  std::vector<double> units_;
  std::vector<Rational> radii_;
};

/// That of most points, about: what grids are made for.
[[nodiscard]] inline double middle_unit(std::vector<double> units) {
  if (units.empty()) return 1;
  const auto middle = units.begin() + static_cast<std::ptrdiff_t>(units.size() / 2);
  std::nth_element(units.begin(), middle, units.end());
  return *middle;
}

}  // namespace delcert
