#include "proofs/publication/latex_table.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(LatexTable, has_columns_of_the_widths_asked_for) {
  EXPECT_EQ(latex_table({{"a", 100}, {"b", 50}}, {{"$1$", ""}, {"block"}, {"x", "y"}}),
            "{\\footnotesize\\setlength{\\tabcolsep}{3pt}%\n"
            "\\begin{longtable}{@{}p{100pt}p{50pt}@{}}\n\\toprule\n"
            "{\\raggedright a\\par} & {\\raggedright b\\par} \\\\\n\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n"
            "{\\raggedright $1$\\par} &  \\\\\n"
            "\\multicolumn{2}{@{}p{156pt}@{}}{{\\raggedright block\\par}} \\\\*\n"
            "{\\raggedright x\\par} & {\\raggedright y\\par} \\\\\n"
            "\\end{longtable}}\n");
}

TEST(LatexTable, keeps_the_place_of_a_column_without_a_heading) {
  const std::string table = latex_table({{"", 10}, {"b", 10}}, {});
  EXPECT_NE(table.find("\\toprule\n & {\\raggedright b\\par} \\\\\n"), std::string::npos) << table;
}

TEST(LatexTable, is_not_wider_than_a_line_of_text) {
  EXPECT_NO_THROW((void)latex_table({{"a", 300}, {"b", 39}}, {}));
  EXPECT_THROW((void)latex_table({{"a", 300}, {"b", 40}}, {}), std::invalid_argument);
}

TEST(LatexTable, has_rows_of_as_many_cells_as_columns) {
  EXPECT_THROW((void)latex_table({{"a", 10}, {"b", 10}, {"c", 10}}, {{"1", "2"}}), std::invalid_argument);
}

TEST(LatexTable, breaks_labels_after_their_signs) {
  EXPECT_EQ(latex_label("lem:a.b_c"), "lem:\\allowbreak{}a.\\allowbreak{}b\\_\\allowbreak{}c");
  EXPECT_EQ(latex_label("x-y/z"), "x-\\allowbreak{}y/\\allowbreak{}z");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
