#include "proofs/publication/exact_latex.hpp"

#include <fmt/format.h>

#include "kernel/number/exact_text.hpp"
#include "support/latex_text.hpp"

namespace delcert {

namespace {

/// Longer ones do not fit beside others in a column.
constexpr std::size_t unbroken_digits = 12;

std::string digits_latex(const Integer& integer) {
  const std::string digits = integer.str();
  return digits.size() > unbroken_digits ? latex_breakable(digits, unbroken_digits / 2) : digits;
}

}  // namespace

std::string exact_latex(const Rational& x) {
  const Integer numerator = x.numerator();
  const Integer denominator = x.denominator();
  if (denominator == 1) return digits_latex(numerator);
  if (exact_text(x).find('p') == std::string::npos)
    return digits_latex(numerator) + "/" + (denominator > 999999 ? "\\allowbreak " : "") + digits_latex(denominator);
  return fmt::format("{} \\cdot 2^{{-{}}}", digits_latex(numerator), msb(denominator));
}

std::string decimal_latex(const std::string& decimal) {
  const auto exponent = decimal.find('e');
  if (exponent == std::string::npos) return decimal;
  return decimal.substr(0, exponent) + " \\cdot 10^{" + decimal.substr(exponent + 1) + "}";
}

}  // namespace delcert
