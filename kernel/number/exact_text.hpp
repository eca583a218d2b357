#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "kernel/number/rational.hpp"
#include "support/error.hpp"

namespace delcert {

/// Text that is not an exact number. The message names the text, the position, what stands there and what was
/// expected; the parts can be had one by one to build a message with a file and a key in it.
class ExactTextError : public InputError {
 public:
  ExactTextError(std::string_view text, std::size_t position, std::string expected, std::string hint = {});

  /// The offset in the text, counted from 0, of the first character that cannot be read.
  [[nodiscard]] std::size_t position() const { return position_; }
  /// What stands there, in quotes, or "the end".
  [[nodiscard]] const std::string& found() const { return found_; }
  [[nodiscard]] const std::string& expected() const { return expected_; }
  /// How to write what was probably meant; empty if there is no guess.
  [[nodiscard]] const std::string& hint() const { return hint_; }

 private:
  std::size_t position_;
  std::string found_;
  std::string expected_;
  std::string hint_;
};

/// The exact text of x, as docs/certificate-format.md says: an integer if x is one; a fraction in lowest terms if the
/// denominator is at most 1024 or not a power of two; otherwise a hexadecimal float with an odd integer as mantissa.
/// A denominator above 2^99999 does not fit the five digits of the exponent and is written as a fraction.
[[nodiscard]] std::string exact_text(const Rational& x);

/// Appends the exact text of x, for writers of many numbers.
void append_exact_text(std::string& text, const Rational& x);

/// Reads any of the three forms; fractions need not be in lowest terms, "-0" is 0. Throws ExactTextError for anything
/// else: empty text, white space, a plus sign, capital letters, a decimal point, denominator 0, a sixth digit of the
/// exponent, trailing characters.
[[nodiscard]] Rational parse_exact(std::string_view text);

}  // namespace delcert
