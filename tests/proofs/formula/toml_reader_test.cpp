#include "proofs/formula/toml_reader.hpp"

#include <gtest/gtest.h>

#include "proofs/formula/parser.hpp"
#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// What `read` makes of a text: "accepted", or the message.
template <class Read>
std::string error_of(const std::string& text, const Read& read) {
  const TomlReader reader(text, "f.toml");
  try {
    read(reader, reader.parse());
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TomlReader, what_is_no_toml_is_an_error_with_its_place) {
  EXPECT_TRUE(error_of("a = \nb = 1\n", [](const TomlReader&, const toml::table&) {}).starts_with("f.toml:1:"));
}

TEST(TomlReader, keys_that_are_missing_unknown_or_no_strings) {
  const auto string = [](const TomlReader& reader, const toml::table& table) {
    (void)reader.string(table, "name", true);
  };
  EXPECT_EQ(error_of("name = 'x'", string), "accepted");
  EXPECT_EQ(error_of("", string), "f.toml:1:1: the key name is missing");
  EXPECT_EQ(error_of("name = 1", string), "f.toml:1:8: the key name wants a string");
  EXPECT_EQ(error_of("name = ''", string), "f.toml:1:8: the key name wants a string that is not empty");
  const auto known = [](const TomlReader& reader, const toml::table& table) { reader.refuse_unknown(table, {"name"}); };
  EXPECT_EQ(error_of("name = 'x'", known), "accepted");
  EXPECT_EQ(error_of("nam = 'x'", known), "f.toml:1:1: unknown key nam, did you mean name?");
  const auto required = [](const TomlReader& reader, const toml::table& table) { (void)reader.required(table, "is"); };
  EXPECT_EQ(error_of("name = 'x'", required), "f.toml:1:1: the key is is missing");
  const auto list = [](const TomlReader& reader, const toml::table& table) { (void)reader.list(table, "given"); };
  EXPECT_EQ(error_of("given = []", list), "accepted");
  EXPECT_EQ(error_of("given = 'x'", list), "f.toml:1:9: the key given wants a list");
}

TEST(TomlReader, names) {
  const auto name = [](const TomlReader& reader, const toml::table& table) {
    reader.require_name(*table.get("name"), reader.string(table, "name", true));
  };
  EXPECT_EQ(error_of("name = 'a-1.b_2'", name), "accepted");
  for (const char* wrong : {"A", "-a", "a b", "ä"}) {
    EXPECT_TRUE(error_of("name = '" + std::string(wrong) + "'", name).starts_with("f.toml:1:8: a name is made of"))
        << wrong;
  }
}

TEST(TomlReader, formulas_point_into_their_strings) {
  const auto formula = [](const TomlReader& reader, const toml::table& table) {
    const Statement read =
        reader.formula(*table.get("claim"), "c", full_vocabulary(), {{"x", types::number}}, types::truth);
    EXPECT_EQ(read.name, "c");
    EXPECT_EQ(read.text, "x > 1");
  };
  EXPECT_EQ(error_of("claim = 'x > 1'", formula), "accepted");
  EXPECT_EQ(error_of("claim = 'x > y'", formula), "f.toml:1:14: nothing here is called y (there are x)");
  EXPECT_EQ(error_of("claim = 'x'", formula), "f.toml:1:10: a number where a statement was expected");
  EXPECT_EQ(error_of("claim = 3", formula), "f.toml:1:9: a formula wants a string");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
