#include "proofs/certificate/json_text.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(JsonText, ReadsWhatItIsAskedForAndSkipsTheRest) {
  JsonText text(R"( {"a" : [[1, -2] ,[ ],[3]], "b":{"x":"]\"}","y":[true,null]},"c":"1/3", "d":-1.5e3,"e":[]} )");
  std::vector<std::vector<int>> rows;
  std::vector<std::string> keys, skipped;
  std::string c;
  text.object([&](std::string_view key) {
    keys.emplace_back(key);
    if (key == "a") {
      text.list([&] {
        rows.emplace_back();
        text.list([&] { rows.back().push_back(text.integer<int>()); });
      });
    } else if (key == "c") {
      c = text.string();
    } else {
      skipped.emplace_back(text.skip());
    }
  });
  text.expect_end();
  EXPECT_EQ(keys, (std::vector<std::string>{"a", "b", "c", "d", "e"}));
  EXPECT_EQ(rows, (std::vector<std::vector<int>>{{1, -2}, {}, {3}}));
  EXPECT_EQ(c, "1/3");
  EXPECT_EQ(skipped, (std::vector<std::string>{R"({"x":"]\"}","y":[true,null]})", "-1.5e3", "[]"}));
}

std::string complaint_about(std::string_view bytes) {
  try {
    JsonText text(bytes);
    text.object([&](std::string_view key) {
      if (key == "rows") {
        text.list([&] { (void)text.integer<std::uint32_t>(); });
      } else {
        (void)text.skip();
      }
    });
    text.expect_end();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(JsonText, SaysWhereATextIsNotAsItShouldBe) {
  EXPECT_EQ(complaint_about(R"({"rows":[1,2]})"), "");
  EXPECT_EQ(complaint_about(R"({"rows":[1,-2]})"),
            "JSON: expected an integer in its range after 11 bytes, found another character");
  EXPECT_EQ(complaint_about(R"({"rows":[1,4294967296]})"),
            "JSON: expected an integer in its range after 11 bytes, found another character");
  EXPECT_EQ(complaint_about(R"({"rows":[1.5]})"), "JSON: expected an integer after 10 bytes, found another character");
  EXPECT_EQ(complaint_about(R"({"rows":[1 2]})"),
            "JSON: expected a comma, or the end of the list or object after 11 bytes, found another character");
  EXPECT_EQ(complaint_about(R"({"rows":[1,2])"),
            "JSON: expected a comma, or the end of the list or object after 13 bytes, found the end of the file");
  EXPECT_EQ(complaint_about(R"({"rows":1})"), "JSON: expected a list after 8 bytes, found another character");
  EXPECT_EQ(complaint_about(R"([1])"), "JSON: expected an object after 0 bytes, found another character");
  EXPECT_EQ(complaint_about(""), "JSON: expected an object after 0 bytes, found the end of the file");
  EXPECT_EQ(complaint_about(R"({a:1})"), "JSON: expected a string after 1 bytes, found another character");
  EXPECT_EQ(complaint_about(R"({"a")"), "JSON: expected a colon after 4 bytes, found the end of the file");
  EXPECT_EQ(complaint_about(R"({"a":})"), "JSON: expected a value after 5 bytes, found another character");
  EXPECT_EQ(complaint_about(R"({"a":[[1])"), "JSON: expected a value after 9 bytes, found the end of the file");
  EXPECT_EQ(complaint_about(R"({"a":"\")"),
            "JSON: expected the end of a string after 8 bytes, found the end of the file");
  EXPECT_EQ(complaint_about(R"({"a":1}x)"), "JSON: expected the end after 7 bytes, found another character");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
