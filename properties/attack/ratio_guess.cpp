#include "properties/attack/ratio_guess.hpp"

#include <fmt/format.h>

#include <cmath>

namespace delcert {

namespace {

constexpr double unbounded_from = 1e6;
constexpr long most_in_denominator = 64;
constexpr double most_in_numerator = 10000;  ///< beyond it the ends of doubles would agree with something
/// Of the numbers between 0 and 1, the fractions p/q with q at most 64 have a share c/q² each, below p/q: 2.5 c in all.
constexpr double agreement = 2e-4;
constexpr double nearest_in_ratio = 1e-3;

struct Fraction {
  long numerator = 0;
  long denominator = 0;
  bool is_attained = false;
};

/// The fraction of the least denominator that agrees with the bounds, from above; 0/0 if none does.
Fraction fraction_from_above(double lower, double upper) {
  for (long q = 1; q <= most_in_denominator; ++q) {
    const auto scale = static_cast<double>(q);
    const double p = std::ceil(lower * scale * (1 - 1e-15));
    const double gap = p / scale - upper;
    if (p < 1 || p > most_in_numerator || gap * scale * scale > agreement || gap > nearest_in_ratio * upper) continue;
    return {static_cast<long>(p), q, gap <= 1e-14 * upper};
  }
  return {};
}

std::string text_of(const Fraction& fraction) {
  return fraction.denominator == 1 ? fmt::format("{}", fraction.numerator)
                                   : fmt::format("{}/{}", fraction.numerator, fraction.denominator);
}

}  // namespace

std::string ratio_guess(const DoubleBounds& ratio) {
  const auto [lower, upper] = ratio;
  if (!(lower > 0)) return "";
  if (lower > unbounded_from) return "looks unbounded";
  const auto said = [](const std::string& number, const Fraction& fraction) {
    return "looks like " + number + (fraction.is_attained ? "" : ", not attained");
  };
  if (const Fraction found = fraction_from_above(lower, upper); found.denominator > 0)
    return said(text_of(found), found);
  if (const Fraction found = fraction_from_above(lower * lower, upper * upper); found.denominator > 0)
    return said("sqrt(" + text_of(found) + ")", found);
  return "";
}

}  // namespace delcert
