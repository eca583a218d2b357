#include "properties/attack/chained_lines.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;
using Lines = std::vector<std::string>;

class ChainedLinesFile : public testing::Test {
 protected:
  void SetUp() override {
    Chain chain;
    for (int number = 1; number <= 4; ++number) lines_.push_back(chain.seal({{"number", number}}));
  }
  void write(const Lines& lines, const std::string& rest = "") const {
    std::ofstream stream(path_, std::ios::binary);
    for (const std::string& line : lines) stream << line << "\n";
    stream << rest;
  }
  ChainedFile read(std::vector<int>& numbers) const {
    Chain chain;
    return read_chained_lines(path_, "the log of a test", chain, [&](const Json& line, std::size_t number) {
      if (line.at("number") == 99) throw InputError("99 is refused");
      numbers.push_back(line.at("number").get<int>());
      EXPECT_EQ(numbers.size(), number);
    });
  }
  std::string error_of() const {
    std::vector<int> numbers;
    try {
      (void)read(numbers);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  static bool is_at(int line, const std::string& error, const std::string& reason) {
    return error.find("log.jsonl:" + std::to_string(line) + ": ") != std::string::npos &&
           error.find(reason) != std::string::npos;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "log.jsonl";
  Lines lines_;
};

TEST_F(ChainedLinesFile, come_back_in_their_order) {
  write(lines_);
  std::vector<int> numbers;
  const ChainedFile file = read(numbers);
  EXPECT_EQ(numbers, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(file.lines, 4U);
  EXPECT_EQ(file.torn, "");
  EXPECT_EQ(file.whole, std::filesystem::file_size(path_));
}

// printf '%s' '{"number":1}' | sha256sum
TEST_F(ChainedLinesFile, have_the_sum_that_other_programs_compute) {
  EXPECT_EQ(lines_[0], "{\"number\":1,\"sum\":\"3d6a916e86efba9105154ea95dda8d8da47df173d931c23e7a346c7babd81a3e\"}");
}

TEST_F(ChainedLinesFile, the_last_of_which_was_cut_off_count_without_it) {
  for (std::size_t length = 0; length < lines_[3].size(); ++length) {
    write({lines_[0], lines_[1], lines_[2]}, lines_[3].substr(0, length));
    std::vector<int> numbers;
    const ChainedFile file = read(numbers);
    EXPECT_EQ(numbers.size(), 3U);
    EXPECT_EQ(file.torn, lines_[3].substr(0, length));
    EXPECT_EQ(file.whole + length, std::filesystem::file_size(path_));
  }
}

TEST_F(ChainedLinesFile, that_were_changed_doubled_left_out_or_moved_are_named) {
  const std::string reason = "its sum is not that of this line";
  Lines forged = lines_;
  forged[1][10] = '7';
  write(forged);
  EXPECT_TRUE(is_at(2, error_of(), reason)) << error_of();
  write({lines_[0], lines_[1], lines_[1], lines_[2]});
  EXPECT_TRUE(is_at(3, error_of(), reason)) << error_of();
  write({lines_[0], lines_[2], lines_[3]});
  EXPECT_TRUE(is_at(2, error_of(), reason)) << error_of();
  write({lines_[0], lines_[2], lines_[1], lines_[3]});
  EXPECT_TRUE(is_at(2, error_of(), reason)) << error_of();
  write({lines_[1], lines_[2]});
  EXPECT_TRUE(is_at(1, error_of(), reason)) << error_of();
  // The twin: what is left out at the end is not missed by the lines before.
  write({lines_[0], lines_[1]});
  EXPECT_EQ(error_of(), "no error");
}

TEST_F(ChainedLinesFile, one_of_which_was_cut_off_in_the_midst_is_named) {
  for (const std::size_t length : {std::size_t{0}, std::size_t{5}, lines_[1].size() - 1}) {
    write({lines_[0], lines_[1].substr(0, length), lines_[2]});
    EXPECT_TRUE(is_at(2, error_of(), "there is no sum at its end")) << error_of();
  }
  write({lines_[0], lines_[1].substr(3), lines_[2]});
  EXPECT_TRUE(is_at(2, error_of(), "its sum is not that")) << error_of();
}

TEST_F(ChainedLinesFile, that_are_no_json_or_are_refused_are_named) {
  Chain chain;
  const std::string first = chain.seal({{"number", 1}});
  write({first, chain.seal({{"number", 99}})});
  EXPECT_TRUE(is_at(2, error_of(), "99 is refused")) << error_of();
  Chain other;
  write({other.seal({{"number", 1}}), other.seal({{"name", "x"}})});
  EXPECT_TRUE(is_at(2, error_of(), "not a line of the log of a test")) << error_of();
}

TEST_F(ChainedLinesFile, of_no_file_cannot_be_read) {
  EXPECT_NE(error_of().find("log.jsonl: cannot be read"), std::string::npos) << error_of();
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
