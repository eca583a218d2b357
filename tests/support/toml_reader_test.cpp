#include "support/toml_reader.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/error.hpp"

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
  EXPECT_EQ(error_of("name = 1", string), "f.toml:1:8: the key name expects a string");
  EXPECT_EQ(error_of("name = ''", string), "f.toml:1:8: the key name expects a string that is not empty");
  const auto known = [](const TomlReader& reader, const toml::table& table) { reader.refuse_unknown(table, {"name"}); };
  EXPECT_EQ(error_of("name = 'x'", known), "accepted");
  EXPECT_EQ(error_of("nam = 'x'", known), "f.toml:1:1: unknown key nam, did you mean name?");
  const auto required = [](const TomlReader& reader, const toml::table& table) { (void)reader.required(table, "is"); };
  EXPECT_EQ(error_of("name = 'x'", required), "f.toml:1:1: the key is is missing");
  const auto list = [](const TomlReader& reader, const toml::table& table) { (void)reader.list(table, "given"); };
  EXPECT_EQ(error_of("given = []", list), "accepted");
  EXPECT_EQ(error_of("given = 'x'", list), "f.toml:1:9: the key given expects a list");
}

TEST(TomlReader, what_the_library_asserts_is_an_error_with_its_place) {
  const auto nothing = [](const TomlReader&, const toml::table&) {};
  EXPECT_TRUE(error_of("[#", nothing).starts_with("f.toml:1:")) << error_of("[#", nothing);
  EXPECT_EQ(error_of("a = 1\n", nothing), "accepted");
}

TEST(TomlReader, keys_that_resemble_none_are_answered_with_all) {
  const auto known = [](const TomlReader& reader, const toml::table& table) {
    reader.refuse_unknown(table, {"name", "family"});
  };
  EXPECT_EQ(error_of("colour = 'x'", known), "f.toml:1:1: unknown key colour, expected: name, family");
}

TEST(TomlReader, a_missing_key_is_said_with_what_was_expected) {
  const auto required = [](const TomlReader& reader, const toml::table& table) {
    (void)reader.required(table, "radius", "a number");
  };
  EXPECT_EQ(error_of("", required), "f.toml:1:1: the key radius is missing, expected a number");
}

TEST(TomlReader, integers_in_a_range) {
  const auto integer = [](const TomlReader& reader, const toml::table& table) {
    EXPECT_EQ(reader.integer(table, "p", 2, 5), 3);
  };
  EXPECT_EQ(error_of("p = 3", integer), "accepted");
  EXPECT_EQ(error_of("p = 6", integer), "f.toml:1:5: key \"p\": found the integer 6, expected an integer from 2 to 5");
  EXPECT_EQ(error_of("p = 1", integer), "f.toml:1:5: key \"p\": found the integer 1, expected an integer from 2 to 5");
  EXPECT_EQ(error_of("p = 3.0", integer),
            "f.toml:1:5: key \"p\": found the floating-point number 3.0, expected an integer from 2 to 5");
  EXPECT_EQ(error_of("", integer), "f.toml:1:1: the key p is missing, expected an integer from 2 to 5");
}

TEST(TomlReader, short_strings) {
  const auto string = [](const TomlReader& reader, const toml::table& table) {
    (void)reader.short_string(table, "name");
  };
  EXPECT_EQ(error_of("name = '" + std::string(64, 'a') + "'", string), "accepted");
  EXPECT_TRUE(
      error_of("name = '" + std::string(65, 'a') + "'", string).ends_with("expected a string of 1 to 64 bytes"));
  EXPECT_TRUE(error_of("name = ''", string).ends_with("found \"\", expected a string of 1 to 64 bytes"));
}

TEST(TomlReader, matrices_entry_by_entry) {
  std::vector<std::string> names;
  const auto matrix = [&](const TomlReader& reader, const toml::table& table) {
    names.clear();
    reader.for_each_entry(
        *table.get("gram"), 2, "gram",
        [&](std::size_t, std::size_t, const toml::node&, const std::string& what) { names.push_back(what); });
  };
  EXPECT_EQ(error_of("gram = [[1, 2], [3, 4]]", matrix), "accepted");
  EXPECT_EQ(names, (std::vector<std::string>{"gram, row 1, entry 1", "gram, row 1, entry 2", "gram, row 2, entry 1",
                                             "gram, row 2, entry 2"}));
  EXPECT_EQ(error_of("gram = [[1, 2], 3]", matrix),
            "f.toml:1:17: gram, row 2: found the integer 3, expected an array of 2 numbers");
  EXPECT_EQ(error_of("gram = [[1, 2]]", matrix),
            "f.toml:1:8: gram: found an array of length 1, expected an array of 2 rows of 2 numbers");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
