#include "proofs/drawing/formats/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace delcert {

namespace {

constexpr int digits = 9;
constexpr int least_exponent = -4;  ///< below it, and from `digits` on, there is an exponent
constexpr std::size_t exponents = digits - least_exponent;

/// The integer of nine digits that a positive double is nearest to, times a power of ten: by arithmetic whose relative
/// error is below 2⁻⁶⁰. Nothing where that cannot tell, or there is an exponent.
struct Rounded {
  std::uint32_t mantissa = 0;
  int exponent = 0;  ///< of the first digit; it has no meaning where the mantissa is 0
};

Rounded rounded(double value) {
  static_assert(std::numeric_limits<long double>::digits >= 64);
  constexpr std::array<double, exponents + 1> tens{1e-4, 1e-3, 1e-2, 1e-1, 1e0, 1e1, 1e2,
                                                   1e3,  1e4,  1e5,  1e6,  1e7, 1e8, 1e9};
  const auto above = std::upper_bound(tens.begin(), tens.end(), value);
  if (above == tens.begin() || above == tens.end()) return {};
  const int exponent = least_exponent - 1 + static_cast<int>(above - tens.begin());
  constexpr std::array<long double, exponents> powers = [] {
    std::array<long double, exponents> result{1};
    for (std::size_t k = 1; k < result.size(); ++k) result[k] = result[k - 1] * 10;
    return result;
  }();
  const long double scaled = static_cast<long double>(value) * powers[static_cast<std::size_t>(digits - 1 - exponent)];
  // Ten to a negative power is no double.
  if (!(scaled >= 100000000.0L && scaled < 1000000000.0L)) return {};
  auto mantissa = static_cast<std::uint32_t>(scaled);
  const long double rest = scaled - static_cast<long double>(mantissa);
  if (std::fabs(rest - 0.5L) < 0x1p-28L) return {};
  if (rest > 0.5L) ++mantissa;
  if (mantissa == 1000000000) return {};
  return {mantissa, exponent};
}

}  // namespace

void append_number(std::string& text, double value) { fmt::format_to(std::back_inserter(text), "{}", value); }

void append_measure(std::string& text, double value) {
  const Rounded found = std::isfinite(value) && value != 0 ? rounded(std::fabs(value)) : Rounded{};
  if (found.mantissa == 0) {
    fmt::format_to(std::back_inserter(text), "{:.9g}", value);
    return;
  }
  std::array<char, digits> decimal;
  std::uint32_t rest = found.mantissa;
  for (auto digit = decimal.rbegin(); digit != decimal.rend(); ++digit, rest /= 10)
    *digit = static_cast<char>('0' + rest % 10);
  // Before the point: the digits of an integer, or 0. After it all but zeros at the end.
  const int whole = std::max(found.exponent + 1, 0);
  const char* const point = decimal.data() + whole;
  const char* last = decimal.data() + digits;
  while (last > point && last[-1] == '0') --last;
  std::array<char, 32> out;
  char* to = out.data();
  if (value < 0) *to++ = '-';
  if (whole == 0) *to++ = '0';
  to = std::copy(static_cast<const char*>(decimal.data()), point, to);
  if (last > point) *to++ = '.';
  for (int place = found.exponent + 1; place < 0; ++place) *to++ = '0';
  to = std::copy(point, last, to);
  text.append(out.data(), static_cast<std::size_t>(to - out.data()));
}

}  // namespace delcert
