#include "properties/instances/choices.hpp"

#include <algorithm>
#include <cmath>

namespace delcert {

long Choices::between(long first, long last) {
  const double width = static_cast<double>(last - first + 1);
  return std::min(last, first + static_cast<long>(std::floor(unit() * width)));
}

Rational Choices::fraction(unsigned bits) {
  return Rational(static_cast<long>(std::floor(std::ldexp(unit(), static_cast<int>(bits))))) *
         Rational::power_of_two(-static_cast<long>(bits));
}

Rational Choices::symmetric(unsigned bits) { return fraction(bits + 1) * Rational(2) - Rational(1); }

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
