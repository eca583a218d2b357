#include "proofs/checker/exact_number.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

#include "proofs/checker/budget.hpp"

namespace delcert::checker {
namespace {

constexpr std::string_view decimal_digits = "0123456789";
constexpr std::string_view hexadecimal_digits = "0123456789abcdef";

/// The longest prefix of `digits`, taken off the text.
std::string_view take(std::string_view& text, std::string_view digits) {
  const std::string_view taken = text.substr(0, text.find_first_not_of(digits));
  text.remove_prefix(taken.size());
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
  const std::string_view digits = parts.hexadecimal ? hexadecimal_digits : decimal_digits;
  parts.whole = take(text, digits);
  if (parts.whole.empty()) return parts;
  if (take_literal(text, parts.hexadecimal ? "." : "/")) {
    parts.part = take(text, digits);
    if (parts.part.empty()) return parts;
    if (!parts.hexadecimal && parts.part.find_first_not_of('0') == std::string_view::npos) return parts;
  }
  if (parts.hexadecimal && take_literal(text, "p")) {
    const bool below = take_literal(text, "-");
    const std::string_view exponent = take(text, decimal_digits);
    if (exponent.empty() || exponent.size() > 5) return parts;
    parts.exponent = (below ? -1 : 1) * std::stoi(std::string(exponent));
  }
  parts.valid = text.empty();
  return parts;
}

}  // namespace

bool is_exact_number(std::string_view text) { return split(text).valid; }

std::optional<double> as_double(std::string_view text) {
  constexpr std::size_t most_digits = 13;
  constexpr int greatest_exponent = 900;
  const Parts parts = split(text);
  const bool is_known = parts.valid && parts.part.empty() && parts.whole.size() <= most_digits &&
                        -greatest_exponent <= parts.exponent && parts.exponent <= greatest_exponent;
  if (!is_known) return std::nullopt;
  std::uint64_t whole = 0;
  std::from_chars(parts.whole.data(), parts.whole.data() + parts.whole.size(), whole, parts.hexadecimal ? 16 : 10);
  const double value = std::ldexp(static_cast<double>(whole), parts.exponent);
  return parts.negative ? -value : value;
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
