#pragma once

#include <cstddef>
#include <string_view>

namespace delcert {

/// A place in a text: both count from 1, columns in characters (not bytes).
struct TextPosition {
  std::size_t line = 1;
  std::size_t column = 1;
  friend bool operator==(const TextPosition&, const TextPosition&) = default;
};

/// Where in a TOML text the byte `offset` of a string's value is written; at its closing quote for the end of the
/// value. Reckons with all four kinds of strings: escapes, the first line break of a long string, lines that a
/// backslash joins. Precondition: a correct string begins at `begin`.
[[nodiscard]] TextPosition position_in_toml_string(std::string_view text, TextPosition begin, std::size_t offset);

}  // namespace delcert
