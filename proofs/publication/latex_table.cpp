#include "proofs/publication/latex_table.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "support/latex_text.hpp"

namespace delcert {

namespace {

/// Between two columns, in pt: twice \tabcolsep.
constexpr int gap_of_columns = 6;

/// Ragged to the end of the paragraph only, so that \\ still ends the row.
std::string ragged_cell(const std::string& cell) { return cell.empty() ? "" : "{\\raggedright " + cell + "\\par}"; }

}  // namespace

std::string latex_table(const std::vector<LatexColumn>& columns, const std::vector<std::vector<std::string>>& rows) {
  int width = -gap_of_columns;
  std::string format;
  std::string head;
  for (const LatexColumn& column : columns) {
    width += column.width + gap_of_columns;
    format += fmt::format("p{{{}pt}}", column.width);
    head += (&column == &columns.front() ? "" : " & ") + ragged_cell(column.heading);
  }
  if (width > latex_line_width)
    throw std::invalid_argument(fmt::format("a table of {} pt, wider than {} pt", width, latex_line_width));
  std::string text = fmt::format(
      "{{\\footnotesize\\setlength{{\\tabcolsep}}{{{}pt}}%\n\\begin{{longtable}}{{@{{}}{}@{{}}}}\n\\toprule\n{} \\\\\n"
      "\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n",
      gap_of_columns / 2, format, head);
  for (const auto& row : rows) {
    if (row.size() == 1) {
      text += fmt::format("\\multicolumn{{{}}}{{@{{}}p{{{}pt}}@{{}}}}{{{}}} \\\\*\n", columns.size(), width,
                          ragged_cell(row[0]));
      continue;
    }
    if (row.size() != columns.size())
      throw std::invalid_argument(fmt::format("a row of {} cells, not {}", row.size(), columns.size()));
    std::string line;
    for (std::size_t at = 0; at < row.size(); ++at) line += (at > 0 ? " & " : "") + ragged_cell(row[at]);
    text += line + " \\\\\n";
  }
  return text + "\\end{longtable}}\n";
}

std::string latex_label(const std::string& name) {
  std::string result;
  std::string part;
  for (const char c : name) {
    part += c;
    if (c != '.' && c != ':' && c != '/' && c != '-' && c != '_') continue;
    result += latex_text(part) + "\\allowbreak{}";
    part.clear();
  }
  return result + latex_text(part);
}

}  // namespace delcert
