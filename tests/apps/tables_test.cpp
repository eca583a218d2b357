#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "proofs/tables/constant_table.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/paper_labels.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

bool is_in_the_table(const std::string& label) {
  const ConstantRows& rows = builtin_constant_rows();
  const auto has_label = [&](const auto& each) { return each.label == label; };
  return std::any_of(rows.rows.begin(), rows.rows.end(), has_label) ||
         std::any_of(rows.without.begin(), rows.without.end(), has_label);
}

TEST(Tables, have_every_lemma_and_theorem_of_the_paper) {
  std::size_t lemmas = 0;
  for (const PaperLabel& label : paper_labels()) {
    const bool is_lemma = label.label.starts_with("lem:") || label.label.starts_with("thm:");
    if (!is_lemma || label.reason.starts_with("another label")) continue;
    ++lemmas;
    EXPECT_TRUE(is_in_the_table(label.label)) << label.label;
  }
  EXPECT_GT(lemmas, 15U);
  EXPECT_FALSE(is_in_the_table("lem:nothing"));
}

TEST(Tables, name_witnesses_that_are_there) {
  const auto entries = constant_entries(builtin_constant_rows(), builtin_files(), {});
  std::size_t witnesses = 0;
  for (const ConstantEntry& entry : entries) {
    if (entry.witness.empty()) continue;
    ++witnesses;
    EXPECT_TRUE(
        std::filesystem::exists(std::filesystem::path(DELCERT_SOURCE_DIR) / "proofs/claims/witnesses" / entry.witness))
        << entry.witness;
  }
  EXPECT_GT(witnesses, 20U);
}

/// A refuted constant is on the other side of the paper's.
TEST(Tables, have_necessary_constants_beyond_those_of_the_paper) {
  for (const ConstantEntry& entry : constant_entries(builtin_constant_rows(), builtin_files(), {})) {
    if (!entry.refuted) continue;
    if (entry.row.direction == Direction::smaller) {
      EXPECT_LT(*entry.refuted, entry.paper) << entry.row.statement;
    } else {
      EXPECT_GT(*entry.refuted, entry.paper) << entry.row.statement;
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
