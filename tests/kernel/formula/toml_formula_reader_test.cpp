#include "kernel/formula/toml_formula_reader.hpp"

#include <gtest/gtest.h>

#include "tests/support/message_of.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(TomlFormulaReader, shows_what_is_wrong_at_its_place_in_the_file) {
  const std::string text = "\n  f = 'ab!'\n  n = 3\n";
  const TomlFormulaReader reader(text, "x.toml");
  const toml::table table = reader.parse();
  const auto read = [](const std::string& formula) {
    const std::size_t at = formula.find('!');
    if (at != std::string::npos) throw FormulaError(at, "no exclamations");
    return formula.size();
  };
  const auto refusal = [&](const char* key) {
    return message_of<InputError>(
        [&] { (void)reader.in_string(reader.required(table, key), "a string, please", read); });
  };
  EXPECT_EQ(refusal("f"), "x.toml:2:10: no exclamations");
  EXPECT_EQ(refusal("n"), "x.toml:3:7: a string, please");
  const std::string fine = "f = 'abc'";
  const TomlFormulaReader other(fine, "y.toml");
  const toml::table there = other.parse();
  EXPECT_EQ(other.in_string(other.required(there, "f"), "a string, please", read), 3U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
