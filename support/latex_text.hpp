#pragma once

#include <string>
#include <string_view>

namespace delcert {

/// Text as LaTeX sets it: what LaTeX takes for commands stands for itself; control characters, bytes that are not
/// UTF-8 and letters that mathematics does not use are named by their code points, U+4E2D, as no font has them all.
/// Greek letters, subscripts and relations are set in mathematical mode.
[[nodiscard]] std::string latex_text(std::string_view text);

/// A word without blanks that LaTeX may break after every `group` letters, as latex_text sets it. Precondition:
/// group > 0.
[[nodiscard]] std::string latex_breakable(std::string_view word, std::size_t group);

}  // namespace delcert
