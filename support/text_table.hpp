#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace delcert {

/// The rows as lines of text whose columns are aligned, two blanks apart; no blanks at the ends of lines. Rows may have
/// different lengths.
[[nodiscard]] std::string text_table(const std::vector<std::vector<std::string>>& rows);

/// Columns that a text in UTF-8 takes on a terminal: its code points without combining marks (as in ρ̃).
[[nodiscard]] std::size_t width_of(const std::string& text);

}  // namespace delcert
