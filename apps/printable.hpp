#pragma once

#include <string>
#include <string_view>

namespace delcert {

/// Text out of a file, for a terminal: what moves the cursor, clears the screen or turns the direction of writing
/// around (control characters, U+0080 to U+009F among them, invisible characters, marks of direction) stands there as
/// \u and four hexadecimal digits; so do bytes that are not UTF-8, as U+FFFD.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace delcert
