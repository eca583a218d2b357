#include "proofs/checker/arithmetic/decimal.hpp"

namespace delcert::checker {
namespace {

constexpr long printed_digits = 6;

Rational power_of_ten(long exponent) {
  const Rational positive = power(Rational(10), static_cast<int>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(1) / positive : positive;
}

/// The digits of an integer as a decimal number with this power of ten.
std::string written(std::string text, long exponent) {
  const bool scientific = exponent < -4 || exponent >= printed_digits;
  const long whole = scientific ? 1 : exponent + 1;  // digits before the point
  if (whole < 1) {
    text.insert(0, std::string(static_cast<std::size_t>(1 - whole), '0'));
    text.insert(1, ".");
  } else {
    text.insert(static_cast<std::size_t>(whole), ".");
  }
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  if (!scientific) return text;
  const std::string size = std::to_string(exponent < 0 ? -exponent : exponent);
  return text + (exponent < 0 ? "e-" : "e+") + (size.size() < 2 ? "0" : "") + size;
}

std::string rounded(const Rational& x, bool up) {
  if (x.sign() == 0) return "0";
  if (x.sign() < 0) return "-" + rounded(-x, !up);
  // 10^exponent <= x < 10^(exponent + 1), from a guess by the numbers of binary digits.
  const auto bits =
      static_cast<long>(fmpz_bits(fmpq_numref(x.raw()))) - static_cast<long>(fmpz_bits(fmpq_denref(x.raw())));
  long exponent = bits * 30103 / 100000;
  while (less(x, power_of_ten(exponent)) == Verdict::proved) --exponent;
  while (less(x, power_of_ten(exponent + 1)) != Verdict::proved) ++exponent;
  const Rational scaled = x * power_of_ten(printed_digits - 1 - exponent);
  fmpz_t integer;
  fmpz_init(integer);
  (up ? fmpz_cdiv_q : fmpz_fdiv_q)(integer, fmpq_numref(scaled.raw()), fmpq_denref(scaled.raw()));
  char* text = fmpz_get_str(nullptr, 10, integer);
  std::string result = text;
  flint_free(text);
  fmpz_clear(integer);
  if (result.size() > printed_digits) {  // 999999.5 becomes 1000000
    result.pop_back();
    ++exponent;
  }
  return written(result, exponent);
}

}  // namespace

std::string rounded_down(const Rational& x) { return rounded(x, false); }
std::string rounded_up(const Rational& x) { return rounded(x, true); }

}  // namespace delcert::checker
