#include "properties/attack/paper_labels.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "properties/attack/claim_library.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(PaperLabels, each_has_a_claim_or_a_reason) {
  for (const std::string& complaint : complaints_about_labels(builtin_claim_list())) ADD_FAILURE() << complaint;
  // The twin: without the claims there is something to say.
  EXPECT_FALSE(complaints_about_labels({}).empty());
}

TEST(PaperLabels, are_mapped_in_the_docs_as_in_the_library) {
  std::ifstream stream(std::filesystem::path(DELCERT_SOURCE_DIR) / "docs/paper-to-code.md");
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  EXPECT_NE(text.find(paper_to_code(builtin_claim_list())), std::string::npos)
      << "docs/paper-to-code.md should have this table:\n"
      << paper_to_code(builtin_claim_list());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
