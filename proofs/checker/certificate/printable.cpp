#include "proofs/checker/certificate/printable.hpp"

#include <array>
#include <cstdio>

namespace delcert::checker {
namespace {

/// Control characters (C0, delete, C1), invisible ones, line ends, and marks of direction.
bool is_hidden(unsigned code) {
  constexpr std::array<std::array<unsigned, 2>, 7> ranges{
      {{0, 0x1f}, {0x7f, 0x9f}, {0xad, 0xad}, {0x200b, 0x200f}, {0x2028, 0x202e}, {0x2060, 0x206f}, {0xfeff, 0xfeff}}};
  for (const auto& [first, last] : ranges) {
    if (first <= code && code <= last) return true;
  }
  return false;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = [&](std::size_t k) {
      return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0u;
    };
    const std::size_t length = byte(0) < 0x80 ? 1 : byte(0) < 0xe0 ? 2 : byte(0) < 0xf0 ? 3 : 4;
    unsigned code = length == 1 ? byte(0) : byte(0) & (0xffu >> (length + 1));
    for (std::size_t k = 1; k < length; ++k) code = code << 6 | (byte(k) & 0x3f);
    if (is_hidden(code)) {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04x", code);
      result += escape.data();
    } else {
      result += text.substr(at, length);
    }
    at += length;
  }
  return result;
}

}  // namespace delcert::checker
