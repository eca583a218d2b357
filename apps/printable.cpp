#include "apps/printable.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace delcert {

namespace {

bool is_hidden(std::uint32_t code) {
  constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 8> ranges{{{0, 0x1f},
                                                                           {0x7f, 0x9f},
                                                                           {0xad, 0xad},
                                                                           {0x200b, 0x200f},
                                                                           {0x2028, 0x202e},
                                                                           {0x2060, 0x206f},
                                                                           {0xfeff, 0xfeff},
                                                                           {0xfffd, 0xfffd}}};
  for (const auto& [first, last] : ranges) {
    if (first <= code && code <= last) return true;
  }
  return false;
}

/// The length of the sequence of UTF-8 that begins the text, and its code; 1 and U+FFFD if it is none.
std::pair<std::size_t, std::uint32_t> first_code(std::string_view text) {
  const auto byte = [&](std::size_t k) { return std::uint32_t{static_cast<unsigned char>(text[k])}; };
  const std::uint32_t first = byte(0);
  if (first < 0x80) return {1, first};
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  constexpr std::pair<std::size_t, std::uint32_t> invalid{1, 0xfffd};
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return invalid;
  std::uint32_t code = first & (0xffU >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xc0) != 0x80) return invalid;
    code = code << 6 | (byte(k) & 0x3f);
  }
  return {length, code};
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto [length, code] = first_code(text);
    result += is_hidden(code) ? fmt::format("\\u{:04x}", code) : std::string(text.substr(0, length));
    text.remove_prefix(length);
  }
  return result;
}

}  // namespace delcert
