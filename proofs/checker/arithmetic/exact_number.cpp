#include "proofs/checker/arithmetic/exact_number.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

#include "proofs/checker/report/budget.hpp"

namespace delcert::checker {
namespace {

/// Of each character whether it is a digit: 1 in decimal numbers too, 2 in hexadecimal ones only, 3 in none.
constexpr std::array<std::uint8_t, 256> digits = [] {
  std::array<std::uint8_t, 256> result{};
  result.fill(3);
  for (unsigned char c = '0'; c <= '9'; ++c) result[c] = 1;
  for (unsigned char c = 'a'; c <= 'f'; ++c) result[c] = 2;
  return result;
}();

/// The longest prefix of digits, taken off the text.
std::string_view take_digits(std::string_view& text, bool hexadecimal) {
  const std::uint8_t most = hexadecimal ? 2 : 1;
  std::size_t length = 0;
  while (length < text.size() && digits[static_cast<unsigned char>(text[length])] <= most) ++length;
  const std::string_view taken = text.substr(0, length);
  text.remove_prefix(length);
  return taken;
}

bool take_literal(std::string_view& text, std::string_view literal) {
  if (!text.starts_with(literal)) return false;
  text.remove_prefix(literal.size());
  return true;
}

/// The parts of a number, and what follows it; the value is +-(whole.part or whole/part) 2^exponent.
struct Parts {
  bool valid = false, negative = false, hexadecimal = false;
  std::string_view whole, part, rest;
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
  parts.valid = true;
  parts.rest = text;
  return parts;
}

}  // namespace

bool is_exact_number(std::string_view text) { return !text.empty() && exact_number_length(text) == text.size(); }

std::size_t exact_number_length(std::string_view text) {
  const Parts parts = split(text);
  return parts.valid ? text.size() - parts.rest.size() : 0;
}

std::optional<Interval> read_enclosure(std::string_view text) {
  constexpr std::size_t most_digits = 16;
  constexpr int greatest_exponent = 900;
  const Parts parts = split(text);
  if (!parts.valid || !parts.rest.empty() || !parts.part.empty() || parts.whole.size() > 200) return std::nullopt;
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
  const double unit = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);  // 2^exponent
  const double low = static_cast<double>(lower) * unit, high = static_cast<double>(lower + (is_exact ? 0 : 1)) * unit;
  return parts.negative ? Interval::between(-high, -low) : Interval::between(low, high);
}

std::vector<Interval> read_enclosures(const std::vector<std::string_view>& texts) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Interval> result;
  result.reserve(texts.size());
  for (const std::string_view text : texts)
    result.push_back(read_enclosure(text).value_or(Interval::between(-infinity, infinity)));
  return result;
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
