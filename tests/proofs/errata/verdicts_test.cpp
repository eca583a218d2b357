#include "proofs/errata/verdicts.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "proofs/errata/erratum.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// The numbers of what changes a theorem, as far as they are theorems.
std::set<std::string> theorems_with_remarks() {
  std::set<std::string> numbers;
  for (const Erratum& erratum : builtin_errata_list())
    if (erratum.number.rfind("Theorem", 0) == 0) numbers.insert(erratum.number);
  return numbers;
}

TEST(Verdicts, are_about_the_three_theorems_and_their_labels) {
  const std::string rows = [] {
    std::ifstream stream(DELCERT_SOURCE_DIR "/proofs/paper/theorem_numbers.tsv");
    return std::string((std::istreambuf_iterator<char>(stream)), {});
  }();
  ASSERT_EQ(theorem_verdicts().size(), 3U);
  std::set<std::string> numbers;
  for (const TheoremVerdict& verdict : theorem_verdicts()) {
    numbers.insert(verdict.number);
    EXPECT_NE(rows.find(verdict.label + "\t" + verdict.number + "\n"), std::string::npos) << verdict.number;
    EXPECT_FALSE(verdict.as_printed.empty() || verdict.hypotheses.empty() || verdict.constants.empty());
  }
  EXPECT_EQ(numbers, theorems_with_remarks());
}

TEST(Verdicts, name_pages_that_exist) {
  const std::regex link(R"(\]\(([^)#]+)\))");
  for (const TheoremVerdict& verdict : theorem_verdicts()) {
    const std::sregex_iterator first(verdict.proof.begin(), verdict.proof.end(), link);
    ASSERT_NE(first, std::sregex_iterator()) << verdict.number;
    for (auto each = first; each != std::sregex_iterator(); ++each)
      EXPECT_TRUE(std::filesystem::exists(DELCERT_SOURCE_DIR "/docs/" + (*each)[1].str())) << (*each)[1];
  }
}

TEST(Verdicts, are_a_section_with_all_that_they_say) {
  const std::string text = verdicts_markdown();
  EXPECT_EQ(text.find("\n## Verdicts\n"), 0U);
  for (const TheoremVerdict& verdict : theorem_verdicts())
    for (const std::string& part : {"### " + verdict.number + " (" + verdict.label + ")", verdict.as_printed,
                                    verdict.hypotheses, verdict.constants, verdict.proof})
      EXPECT_NE(text.find(part), std::string::npos) << part;
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
