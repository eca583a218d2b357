#include "kernel/number/decimal_bounds.hpp"

namespace delcert {

namespace {

Rational power_of_ten(long exponent) { return power(Rational(10), exponent); }

/// The exponent e with 10^e <= x < 10^(e+1). Precondition: x > 0.
long decimal_exponent(const Rational& x) {
  // 0.30103 is log10(2) to five digits: a guess, put right by the loops.
  long exponent = binary_exponent(x) * 30103 / 100000;
  while (power_of_ten(exponent) > x) --exponent;
  while (power_of_ten(exponent + 1) <= x) ++exponent;
  return exponent;
}

std::string without_trailing_zeros(std::string digits, std::size_t kept) {
  while (digits.size() > kept && digits.back() == '0') digits.pop_back();
  return digits;
}

/// The number 0.d₁d₂… × 10^(exponent+1).
std::string layout(const std::string& digits, long exponent) {
  const auto count = static_cast<long>(digits.size());
  if (exponent < -4 || exponent >= count) {
    const std::string short_digits = without_trailing_zeros(digits, 1);
    const std::string fraction = short_digits.size() == 1 ? "" : "." + short_digits.substr(1);
    return short_digits.substr(0, 1) + fraction + "e" + std::to_string(exponent);
  }
  if (exponent < 0) {
    const std::string zeros(static_cast<std::size_t>(-exponent - 1), '0');
    return "0." + zeros + without_trailing_zeros(digits, 1);
  }
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  const std::string short_digits = without_trailing_zeros(digits, whole);
  return short_digits.size() == whole ? short_digits : short_digits.substr(0, whole) + "." + short_digits.substr(whole);
}

std::string positive_decimal(const Rational& x, int digits, bool upwards) {
  long exponent = decimal_exponent(x);
  const Rational scaled = x * power_of_ten(digits - 1 - exponent);
  Integer mantissa = upwards ? ceiling_of(scaled) : floor_of(scaled);
  std::string text = mantissa.str();
  if (static_cast<int>(text.size()) > digits) {
    text.pop_back();
    ++exponent;
  }
  return layout(text, exponent);
}

std::string decimal(const Rational& x, int digits, bool upwards) {
  if (x == Rational(0)) return "0";
  if (x < Rational(0)) return "-" + positive_decimal(-x, digits, !upwards);
  return positive_decimal(x, digits, upwards);
}

}  // namespace

std::string decimal_lower(const Rational& x, int digits) { return decimal(x, digits, false); }

std::string decimal_upper(const Rational& x, int digits) { return decimal(x, digits, true); }

}  // namespace delcert
