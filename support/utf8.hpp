#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace delcert {

/// The length in bytes of the sequence of UTF-8 that begins the text, and its code point; 1 and U+FFFD if it is none.
/// Precondition: the text is not empty.
[[nodiscard]] std::pair<std::size_t, std::uint32_t> first_code_point(std::string_view text);

}  // namespace delcert
