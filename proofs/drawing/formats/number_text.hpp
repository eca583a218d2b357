#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <string>

namespace delcert {

/// Appends an integer in decimal digits.
template <std::integral T>
void append_number(std::string& text, T value) {
  std::array<char, 24> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

/// Appends the shortest text that reads back as the same double: "0.1", "1e-07", "nan".
void append_number(std::string& text, double value);

/// Appends a double, rounded to nine significant digits, without zeros at the end: what printf writes for "%.9g".
void append_measure(std::string& text, double value);

}  // namespace delcert
