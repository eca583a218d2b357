#include "proofs/checker/arithmetic/exact_number.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

#include "proofs/checker/report/budget.hpp"

namespace delcert::checker {
namespace {

/// The longest prefix of digits, taken off the text.
std::string_view take_digits(std::string_view& text, bool hexadecimal) {
  const unsigned letters = hexadecimal ? 6 : 0;
  std::size_t length = 0;
  for (; length < text.size(); ++length) {
    const auto c = static_cast<unsigned>(text[length]);
    if (c - '0' >= 10 && c - 'a' >= letters) break;
  }
  const std::string_view taken = text.substr(0, length);
  text.remove_prefix(length);
  return taken;
}

bool take_literal(std::string_view& text, std::string_view literal) {
  if (!text.starts_with(literal)) return false;
  text.remove_prefix(literal.size());
  return true;
}

/// The parts of a number; the value is +-(whole.part or whole/part) 2^exponent.
struct Parts {
  bool valid = false, negative = false, hexadecimal = false;
  std::string_view whole, part;
  int exponent = 0;
};

Parts split(std::string_view text) {
  Parts parts;
  parts.negative = take_literal(text, "-");
  parts.hexadecimal = take_literal(text, "0x");
  parts.whole = take_digits(text, parts.hexadecimal);
  if (parts.whole.empty()) return parts;
  if (take_literal(text, parts.hexadecimal ? "." : "/")) {
    parts.part = take_digits(text, parts.hexadecimal);
    if (parts.part.empty()) return parts;
    if (!parts.hexadecimal && parts.part.find_first_not_of('0') == std::string_view::npos) return parts;
  }
  if (parts.hexadecimal && take_literal(text, "p")) {
    const bool below = take_literal(text, "-");
    const std::string_view exponent = take_digits(text, false);
    if (exponent.empty() || exponent.size() > 5) return parts;
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), parts.exponent);
    if (below) parts.exponent = -parts.exponent;
  }
  parts.valid = text.empty();
  return parts;
}

}  // namespace

bool is_exact_number(std::string_view text) { return split(text).valid; }

std::optional<Interval> read_enclosure(std::string_view text) {
  constexpr std::size_t most_digits = 16;
  constexpr int greatest_exponent = 900;
  const Parts parts = split(text);
  if (!parts.valid || !parts.part.empty() || parts.whole.size() > 200) return std::nullopt;
  const std::string_view first = parts.whole.substr(0, most_digits), others = parts.whole.substr(first.size());
  std::uint64_t whole = 0;
  std::from_chars(first.data(), first.data() + first.size(), whole, parts.hexadecimal ? 16 : 10);
  // Its first 53 binary digits; what follows is less than one of the last of them.
  const int shift = std::max(static_cast<int>(std::bit_width(whole)) - 53, 0);
  const int exponent = parts.exponent + 4 * static_cast<int>(others.size()) + shift;
  const bool is_known = (others.empty() || (parts.hexadecimal && shift > 0)) && -greatest_exponent <= exponent &&
                        exponent <= greatest_exponent;
  if (!is_known) return std::nullopt;
  const std::uint64_t lower = whole >> shift;
  const bool is_exact = lower << shift == whole && others.find_first_not_of('0') == std::string_view::npos;
  const double low = std::ldexp(static_cast<double>(lower), exponent),
               high = std::ldexp(static_cast<double>(lower + (is_exact ? 0 : 1)), exponent);
  return parts.negative ? Interval::between(-high, -low) : Interval::between(low, high);
}

Rational exact_value(std::string_view text) {
  const Parts parts = split(text);
  Budget::spend(text.size() + text.size() * text.size() / 4096);  // of long division
  Rational value;
  fmpz* numerator = fmpq_numref(value.raw());
  fmpz* denominator = fmpq_denref(value.raw());
  if (parts.hexadecimal) {
    fmpz_set_str(numerator, (std::string(parts.whole) + std::string(parts.part)).c_str(), 16);
    const slong exponent = parts.exponent - 4 * static_cast<slong>(parts.part.size());
    fmpz* scale = exponent < 0 ? denominator : numerator;
    fmpz_mul_2exp(scale, scale, static_cast<ulong>(exponent < 0 ? -exponent : exponent));
  } else {
    fmpz_set_str(numerator, std::string(parts.whole).c_str(), 10);
    if (!parts.part.empty()) fmpz_set_str(denominator, std::string(parts.part).c_str(), 10);
  }
  if (parts.negative) fmpz_neg(numerator, numerator);
  fmpq_canonicalise(value.raw());
  return value;
}

}  // namespace delcert::checker
