#include "proofs/formula/formula_reader.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/parser.hpp"
#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// What `read` makes of a text: "accepted", or the message.
template <class Read>
std::string error_of(const std::string& text, const Read& read) {
  const FormulaReader reader(text, "f.toml");
  try {
    read(reader, reader.parse());
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FormulaReader, names) {
  const auto name = [](const FormulaReader& reader, const toml::table& table) {
    reader.require_name(*table.get("name"), reader.string(table, "name", true));
  };
  EXPECT_EQ(error_of("name = 'a-1.b_2'", name), "accepted");
  for (const char* wrong : {"A", "-a", "a b", "ä"}) {
    EXPECT_TRUE(error_of("name = '" + std::string(wrong) + "'", name).starts_with("f.toml:1:8: a name is made of"))
        << wrong;
  }
}

TEST(FormulaReader, formulas_point_into_their_strings) {
  const auto formula = [](const FormulaReader& reader, const toml::table& table) {
    const Statement read =
        reader.formula(*table.get("claim"), "c", full_vocabulary(), {{"x", types::number}}, types::truth);
    EXPECT_EQ(read.name, "c");
    EXPECT_EQ(read.text, "x > 1");
  };
  EXPECT_EQ(error_of("claim = 'x > 1'", formula), "accepted");
  EXPECT_EQ(error_of("claim = 'x > y'", formula), "f.toml:1:14: nothing here is called y (there are x)");
  EXPECT_EQ(error_of("claim = 'x'", formula), "f.toml:1:10: a number where a statement was expected");
  EXPECT_EQ(error_of("claim = 3", formula), "f.toml:1:9: a formula expects a string");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
