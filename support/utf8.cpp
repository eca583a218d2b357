#include "support/utf8.hpp"

namespace delcert {

std::pair<std::size_t, std::uint32_t> first_code_point(std::string_view text) {
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

}  // namespace delcert
