#include "properties/instances/choices.hpp"

#include <algorithm>
#include <cmath>

namespace delcert {

long Choices::between(long first, long last) {
  const double width = static_cast<double>(last - first + 1);
  return std::min(last, first + static_cast<long>(std::floor(unit() * width)));
}

namespace {

/// The multiple of 2^−bits that is not above a number in [0, 1): without an error, since doubles have 53 digits.
double rounded_to_bits(double unit, unsigned bits) {
  const int exponent = static_cast<int>(bits);
  return std::ldexp(std::floor(std::ldexp(unit, exponent)), -exponent);
}

}  // namespace

Rational Choices::fraction(unsigned bits) { return Rational::exactly(rounded_to_bits(unit(), bits)); }

// A number of [0, 1) in 53 digits, doubled, less 1, has 53 digits too.
Rational Choices::symmetric(unsigned bits) { return Rational::exactly(2 * rounded_to_bits(unit(), bits + 1) - 1); }

double GivenChoices::unit() {
  constexpr double largest = 0x1.fffffffffffffp-1;
  const std::size_t at = taken_++;
  if (at >= values_.size()) return 0.5;
  // A search may step on the ends of the interval or, by rounding, beyond. Not a number counts as 0.
  const double value = values_[at] > 0 ? std::min(values_[at], largest) : 0;
  return std::floor(value * 0x1p53) * 0x1p-53;
}

std::uint32_t stream_of(std::string_view text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

}  // namespace delcert
