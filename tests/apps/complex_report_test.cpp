#include "apps/complex_report.hpp"

#include <gtest/gtest.h>

#include "tests/support/complex_texts.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const ComplexDescription& klein() {
  static const ComplexDescription complex = parse_complex(complex_text("klein-bottle-9"), "x.toml");
  return complex;
}

TEST(ComplexReport, says_findings_in_the_names_of_the_file) {
  EXPECT_EQ(in_names_of(klein(), "simplex {0, 1, 5} without its label 5 is in 1 simplices"),
            "simplex {a0, a1, b2} without its point b2 is in 1 simplices");
  EXPECT_EQ(in_names_of(klein(), "loop 1 is not a closed path at label 0 along generator 3"),
            "loop 1 is not a closed path at point a0 along generator e2");
  EXPECT_EQ(in_names_of(klein(), "{99} and label 99, generator 4, generator 0, 0.125"),
            "{99} and point 99, generator 4, generator 0, 0.125");
}

TEST(ComplexReport, takes_each_finding_once) {
  const std::string finding = R"({"rule":"core.sign","what":"simplex {0, 1, 2} is flat"})";
  EXPECT_EQ(findings_text(klein(), R"({"status":"rejected","malformed":null,"levels":[{"findings":[)" + finding +
                                       R"(]},{"findings":[)" + finding + "]}]}"),
            "\n  core.sign: simplex {a0, a1, a2} is flat");
  EXPECT_EQ(findings_text(klein(), R"({"status":"verified","malformed":null,"levels":[{"findings":[]}]})"), "");
  EXPECT_EQ(findings_text(klein(), R"({"status":"undecided","malformed":null,"levels":[]})"), "\n  undecided");
  EXPECT_EQ(findings_text(klein(), R"({"status":"malformed","malformed":{"rule":"form.x","what":"y"},"levels":[]})"),
            "\n  form.x: y");
  EXPECT_THROW((void)findings_text(klein(), "verified"), std::runtime_error);
  EXPECT_THROW((void)findings_text(klein(), "{}"), std::runtime_error);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
