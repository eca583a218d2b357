#include "proofs/certificate/document.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Document, NumbersAndStringsAreThoseOfTheFormat) {
  EXPECT_EQ(number(Rational(3)), "\"3\"");
  EXPECT_EQ(number(Rational(Integer(-1), Integer(3))), "\"-1/3\"");
  EXPECT_EQ(number(Rational::power_of_two(-20)), "\"0x1p-20\"");
  EXPECT_EQ(quoted("a \"b\"\n"), "\"a \\\"b\\\"\\n\"");
  EXPECT_EQ(listed(std::vector<int>{}, [](int x) { return std::to_string(x); }), "[]");
  EXPECT_EQ(listed(std::vector<int>{1, 2}, [](int x) { return std::to_string(x); }), "[1,2]");
}

TEST(Document, ArraysLongerThanTheBufferAreWrittenWhole) {
  const test::TemporaryFolder folder;
  constexpr std::size_t count = 30000;
  {
    const Progress progress = no_progress();
    Document document(folder / "d.json", count, progress);
    document.add("{\"first\":0");
    document.add_array("long", count, [](std::size_t at) { return std::to_string(at); });
    EXPECT_FALSE(std::filesystem::exists(folder / "d.json")) << "before it is sealed";
    document.seal();
  }
  const auto json = nlohmann::ordered_json::parse(bytes_of(folder / "d.json"));
  ASSERT_EQ(json.at("long").size(), count);
  EXPECT_EQ(json.at("long")[count - 1], count - 1);
  EXPECT_EQ(json.at("sha256").get<std::string>().size(), 64U);
}

TEST(Document, OneThatIsGivenUpLeavesNoFile) {
  const test::TemporaryFolder folder;
  const Progress stop = [](std::string_view, std::size_t, std::size_t) { throw std::runtime_error("stop"); };
  Document document(folder / "d.json", 1000, stop);
  const auto zero = [](std::size_t) { return std::string("0"); };
  EXPECT_THROW(document.add_array("long", 1000, zero), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder / "d.json"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
