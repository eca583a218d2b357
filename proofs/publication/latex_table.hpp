#pragma once

#include <string>
#include <vector>

namespace delcert {

/// The width of a column of text of `article` at 10 pt, in pt: what all tables fit.
inline constexpr int latex_line_width = 345;

struct LatexColumn {
  std::string heading;
  int width;  ///< in pt, of the text in it
};

/// A longtable (packages longtable and booktabs) of these columns; cells are LaTeX, ragged, broken between words, after
/// \allowbreak and in formulas after relations and signs. A row of one cell goes over all columns. Throws
/// std::invalid_argument where the columns are wider than a line of text, and for a row with another number of cells.
[[nodiscard]] std::string latex_table(const std::vector<LatexColumn>& columns,
                                      const std::vector<std::vector<std::string>>& rows);

/// A name of several words, such as a label or lemma/conclusion, that can be broken after its signs.
[[nodiscard]] std::string latex_label(const std::string& name);

}  // namespace delcert
