#include "apps/printable.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "support/utf8.hpp"

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

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto [length, code] = first_code_point(text);
    result += is_hidden(code) ? fmt::format("\\u{:04x}", code) : std::string(text.substr(0, length));
    text.remove_prefix(length);
  }
  return result;
}

}  // namespace delcert
