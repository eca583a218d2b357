#include "proofs/formula/vocabulary_text.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "proofs/formula/arithmetic_vocabulary.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {
namespace {

TEST(VocabularyText, a_function_is_shown_with_its_types) {
  const Vocabulary& vocabulary = full_vocabulary();
  EXPECT_EQ(signature_text(*vocabulary.function("altitude")), "altitude(simplex, integer) -> number");
  EXPECT_EQ(signature_text(*vocabulary.function("min")), "min(number, ...) -> number");
  EXPECT_EQ(signature_text(*vocabulary.function("range")), "range(integer, integer) -> set of integer");
  EXPECT_EQ(signature_text(*vocabulary.function("is_good")), "is_good(simplex, number) -> truth");
}

TEST(VocabularyText, tables_have_a_line_for_each_function_and_definition) {
  Vocabulary vocabulary;
  add_arithmetic(vocabulary);
  vocabulary.add_definition("twice", {"x", "k"}, "2*x + k", "A | in a cell.", "2x");
  const std::string table = vocabulary_table(vocabulary);
  EXPECT_NE(table.find("| `sqrt(number) -> number` | The square root, undefined for negative numbers. |\n"),
            std::string::npos);
  EXPECT_NE(table.find("| `twice(x, k)` | `2*x + k` | A \\| in a cell. |\n"), std::string::npos);
}

/// The part of docs/claim-format.md between the two comments.
TEST(VocabularyText, the_manual_has_the_table_of_the_whole_vocabulary) {
  std::ifstream stream(DELCERT_SOURCE_DIR "/docs/claim-format.md", std::ios::binary);
  std::stringstream content;
  content << stream.rdbuf();
  const std::string text = content.str();
  const std::string begin = "<!-- functions: generated -->\n";
  const std::string end = "<!-- functions: end -->\n";
  const std::size_t from = text.find(begin);
  const std::size_t to = text.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  EXPECT_EQ(text.substr(from + begin.size(), to - from - begin.size()), vocabulary_table(full_vocabulary()))
      << "docs/claim-format.md: put in the output of `delcert claims functions`";
}

}  // namespace
}  // namespace delcert
