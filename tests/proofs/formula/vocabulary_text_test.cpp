#include "proofs/formula/vocabulary_text.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/arithmetic_vocabulary.hpp"
#include "properties/instances/instance_class.hpp"
#include "tests/proofs/formula/source_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

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

TEST(VocabularyText, tables_have_a_line_for_each_term_over_a_set) {
  const std::string table = vocabulary_table(full_vocabulary());
  for (const TermOverSet& term : terms_over_sets()) {
    EXPECT_TRUE(operation_over_set(term.word).has_value()) << term.word;
    EXPECT_NE(table.find("| `" + std::string(term.word) + "(x in set: number) -> number` | "), std::string::npos);
  }
  EXPECT_EQ(terms_over_sets().size(), 4U);
}

/// The part of docs/claim-format.md between two comments.
std::string generated_part(const std::string& name) {
  std::ifstream stream(source_folder() / "docs/claim-format.md", std::ios::binary);
  std::stringstream content;
  content << stream.rdbuf();
  const std::string text = content.str();
  const std::string begin = "<!-- " + name + ": generated -->\n";
  const std::size_t from = text.find(begin);
  const std::size_t to = text.find("<!-- " + name + ": end -->\n");
  if (from == std::string::npos || to == std::string::npos) return "no part " + name;
  return text.substr(from + begin.size(), to - from - begin.size());
}

TEST(VocabularyText, the_manual_has_the_table_of_the_whole_vocabulary) {
  EXPECT_EQ(generated_part("functions"), vocabulary_table(full_vocabulary()));
}

TEST(VocabularyText, the_manual_has_all_instance_classes_with_what_they_bind) {
  std::string table = "| class | an instance is | binds |\n|---|---|---|\n";
  for (const InstanceClass* each : instance_classes()) {
    std::string bound;
    for (const auto& [name, type] : each->signature()) {
      bound += (bound.empty() ? "`" : ", `") + name + "` " + type.text();
    }
    table += "| `" + each->name() + "` | " + each->meaning() + " | " + bound + " |\n";
  }
  EXPECT_EQ(generated_part("classes"), table);
}

TEST(VocabularyText, a_part_that_is_not_there_is_noticed) { EXPECT_EQ(generated_part("nothing"), "no part nothing"); }

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
