#include "kernel/number/exact_text.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>

namespace delcert {

namespace {

constexpr long greatest_exponent = 99999;
constexpr std::size_t exponent_digits = 5;
constexpr unsigned long greatest_fraction_denominator = 1024;

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hexadecimal_digit(char c) { return is_decimal_digit(c) || (c >= 'a' && c <= 'f'); }

// Texts come from files: what is quoted stays short and printable.
std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text.substr(0, longest)) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code >= 0x7f) {
      result += "\\x";
      result += digits[code / 16];
      result += digits[code % 16];
    } else {
      result += c;
    }
  }
  result += text.size() > longest ? "…\"" : "\"";
  return result;
}

std::string found_at(std::string_view text, std::size_t position) {
  return position < text.size() ? quoted(text.substr(position, 1)) : "the end";
}

std::string message(std::string_view text, std::size_t position, const std::string& expected, const std::string& hint) {
  std::string result = "not an exact number: " + quoted(text) + ": found " + found_at(text, position) +
                       " after character " + std::to_string(position) + ", expected " + expected;
  if (!hint.empty()) result += "; " + hint;
  return result;
}

void append_integer(std::string& text, mpz_srcptr integer, int base) {
  if (mpz_fits_slong_p(integer) != 0) {
    std::array<char, 72> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), mpz_get_si(integer), base).ptr;
    text.append(buffer.data(), end);
    return;
  }
  const std::size_t start = text.size();
  text.resize(start + mpz_sizeinbase(integer, base) + 2);
  mpz_get_str(text.data() + start, base, integer);
  text.resize(text.find('\0', start));
}

void set_integer(mpz_ptr integer, std::string_view digits, int base) {
  constexpr std::size_t digits_of_a_word = 15;
  if (digits.size() <= digits_of_a_word) {
    std::uint64_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    mpz_set_ui(integer, value);
    return;
  }
  mpz_set_str(integer, std::string(digits).c_str(), base);
}

// A decimal point may only be meant as a decimal fraction: say how that is written.
std::string hint_for_decimal_point(std::string_view text) {
  constexpr std::size_t longest = 20;
  const bool negative = text.starts_with('-');
  const std::string_view size = text.substr(negative ? 1 : 0);
  const std::size_t point = size.find('.');
  if (point == std::string_view::npos || size.starts_with("0x")) return {};
  const std::string_view whole = size.substr(0, point);
  const std::string_view part = size.substr(point + 1);
  const auto digits_only = [](std::string_view digits) {
    for (const char c : digits)
      if (!is_decimal_digit(c)) return false;
    return !digits.empty();
  };
  if (!digits_only(whole) || !digits_only(part) || size.size() > longest)
    return "decimal points are not accepted: write a fraction, 1/10";
  std::string numerator = std::string(whole) + std::string(part);
  numerator.erase(0, std::min(numerator.find_first_not_of('0'), numerator.size() - 1));
  return "decimal points are not accepted: write " + std::string(negative ? "-" : "") + numerator + "/1" +
         std::string(part.size(), '0');
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Rational read() {
    Rational::Wrapped value;
    mpq_ptr raw = value.backend().data();
    const bool negative = accept('-');
    if (text_.substr(position_).starts_with("0x")) {
      position_ += 2;
      read_hexadecimal(raw);
    } else {
      read_decimal(raw);
    }
    if (negative) mpq_neg(raw, raw);
    return Rational(std::move(value));
  }

 private:
  void read_decimal(mpq_ptr raw) {
    set_integer(mpq_numref(raw), digits(is_decimal_digit, "a decimal digit"), 10);
    if (!accept('/')) {
      const bool lone_zero = text_.substr(0, position_) == "0" || text_.substr(0, position_) == "-0";
      return expect_end(lone_zero ? "a decimal digit, \"/\", \"x\" or the end" : "a decimal digit, \"/\" or the end");
    }
    const std::size_t start = position_;
    set_integer(mpq_denref(raw), digits(is_decimal_digit, "a decimal digit"), 10);
    expect_end("a decimal digit or the end");
    if (mpz_sgn(mpq_denref(raw)) == 0) throw ExactTextError(text_, start, "a denominator other than 0");
    mpq_canonicalize(raw);
  }

  void read_hexadecimal(mpq_ptr raw) {
    const std::string_view whole = digits(is_hexadecimal_digit, "a hexadecimal digit, lower case");
    std::string_view part;
    if (accept('.')) part = digits(is_hexadecimal_digit, "a hexadecimal digit, lower case");
    if (part.empty()) {
      set_integer(mpq_numref(raw), whole, 16);
    } else {
      set_integer(mpq_numref(raw), std::string(whole) + std::string(part), 16);
    }
    const bool has_exponent = accept('p');
    const long exponent = has_exponent ? read_exponent() : 0;
    expect_end(has_exponent   ? "a decimal digit or the end"
               : part.empty() ? "a hexadecimal digit, lower case, \".\", \"p\" or the end"
                              : "a hexadecimal digit, lower case, \"p\" or the end");
    const long shift = exponent - 4 * static_cast<long>(part.size());
    if (shift >= 0) {
      mpq_mul_2exp(raw, raw, static_cast<mp_bitcnt_t>(shift));
    } else {
      mpq_div_2exp(raw, raw, static_cast<mp_bitcnt_t>(-shift));
    }
  }

  long read_exponent() {
    const bool negative = accept('-');
    const std::size_t start = position_;
    const std::string_view read = digits(is_decimal_digit, "a decimal digit");
    if (read.size() > exponent_digits)
      throw ExactTextError(text_, start + exponent_digits, "at most 5 digits of exponent");
    long value = 0;
    std::from_chars(read.data(), read.data() + read.size(), value);
    return negative ? -value : value;
  }

  bool accept(char c) {
    if (position_ == text_.size() || text_[position_] != c) return false;
    ++position_;
    return true;
  }

  std::string_view digits(bool (*is_digit)(char), const char* expected) {
    const std::size_t start = position_;
    while (position_ < text_.size() && is_digit(text_[position_])) ++position_;
    if (position_ == start) fail(expected);
    return text_.substr(start, position_ - start);
  }

  void expect_end(const char* expected) {
    if (position_ != text_.size()) fail(expected);
  }

  [[noreturn]] void fail(const char* expected) const {
    const bool at_point = position_ < text_.size() && text_[position_] == '.';
    throw ExactTextError(text_, position_, expected, at_point ? hint_for_decimal_point(text_) : std::string());
  }

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace

ExactTextError::ExactTextError(std::string_view text, std::size_t position, std::string expected, std::string hint)
    : InputError(message(text, position, expected, hint)),
      position_(position),
      found_(found_at(text, position)),
      expected_(std::move(expected)),
      hint_(std::move(hint)) {}

void append_exact_text(std::string& text, const Rational& x) {
  mpz_srcptr numerator = mpq_numref(x.gmp());
  mpz_srcptr denominator = mpq_denref(x.gmp());
  if (mpz_cmp_ui(denominator, 1) == 0) return append_integer(text, numerator, 10);
  const mp_bitcnt_t exponent = mpz_scan1(denominator, 0);
  const bool is_power_of_two = mpz_sizeinbase(denominator, 2) == exponent + 1;
  if (!is_power_of_two || exponent > static_cast<mp_bitcnt_t>(greatest_exponent) ||
      mpz_cmp_ui(denominator, greatest_fraction_denominator) <= 0) {
    append_integer(text, numerator, 10);
    text += '/';
    return append_integer(text, denominator, 10);
  }
  // In lowest terms over a power of two: the numerator is odd.
  if (mpz_sgn(numerator) < 0) text += '-';
  text += "0x";
  __mpz_struct size = *numerator;
  size._mp_size = std::abs(size._mp_size);
  append_integer(text, &size, 16);
  text += "p-";
  text += std::to_string(exponent);
}

std::string exact_text(const Rational& x) {
  std::string text;
  append_exact_text(text, x);
  return text;
}

Rational parse_exact(std::string_view text) { return Reader(text).read(); }

}  // namespace delcert
