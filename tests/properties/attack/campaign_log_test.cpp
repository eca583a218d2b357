#include "properties/attack/campaign_log.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

class CampaignLogFile : public testing::Test {
 protected:
  std::string text() const {
    std::ifstream stream(path_, std::ios::binary);
    std::stringstream buffer;
    buffer << stream.rdbuf();
    return buffer.str();
  }
  void write(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }

  /// A log of two blocks.
  void write_two_blocks() const {
    CampaignLog log(path_, "one");
    log.append({0, 0}, tally_);
    log.append({2, 250}, tally_);
  }
  std::string error_of(const std::string& identity) const {
    try {
      const CampaignLog log(path_, identity);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "log.jsonl";
  Tally tally_ = attack_block(test::wrong_claim(), {2, 2}, 1, 0, 20);
};

TEST_F(CampaignLogFile, what_was_appended_is_finished_when_it_is_opened_again) {
  write_two_blocks();
  const CampaignLog log(path_, "one");
  ASSERT_EQ(log.finished().size(), 2U);
  EXPECT_EQ(tally_json(log.finished().at({2, 250})).dump(), tally_json(tally_).dump());
}

TEST_F(CampaignLogFile, wherever_a_crash_cuts_it_off_whole_lines_count_and_it_can_go_on) {
  write_two_blocks();
  const std::string whole = text();
  const std::size_t first = whole.find('\n') + 1;
  const std::size_t second = whole.find('\n', first) + 1;
  for (std::size_t length = 0; length <= whole.size(); length += length > first ? 13 : 1) {
    write(whole.substr(0, length));
    CampaignLog log(path_, "one");
    EXPECT_EQ(log.finished().size(), length < second ? 0U : length < whole.size() ? 1U : 2U) << length;
    log.append({0, 0}, tally_);
    log.append({2, 250}, tally_);
    EXPECT_EQ(CampaignLog(path_, "one").finished().size(), 2U) << length;
  }
}

TEST_F(CampaignLogFile, of_another_campaign_it_is_refused_and_left_as_it_is) {
  write_two_blocks();
  const std::string before = text();
  EXPECT_NE(error_of("two").find("log.jsonl:1: the log of another campaign"), std::string::npos) << error_of("two");
  EXPECT_EQ(text(), before);
}

TEST_F(CampaignLogFile, a_file_that_is_no_log_is_refused_and_left_as_it_is) {
  for (const char* other : {"my diary", "my diary\n", "{}\n", "[1]\n", "\n", "{\"delcert_campaign\": 1}\n"}) {
    write(other);
    EXPECT_NE(error_of("one").find("log.jsonl:1: "), std::string::npos) << other;
    EXPECT_EQ(text(), other);
  }
}

TEST_F(CampaignLogFile, a_line_in_the_midst_that_is_none_is_named) {
  write_two_blocks();
  const std::string whole = text();
  const std::size_t first = whole.find('\n') + 1;
  for (const char* line :
       {"", "{", "{}", "{\"target\": 0, \"first\": 0}", "{\"target\": \"x\", \"first\": 0, \"tally\": {}}",
        "{\"target\": 0, \"first\": 0, \"tally\": []}"}) {
    write(whole.substr(0, first) + line + "\n" + whole.substr(first));
    EXPECT_NE(error_of("one").find("log.jsonl:2: "), std::string::npos) << line;
  }
}

TEST_F(CampaignLogFile, an_empty_path_keeps_nothing_and_one_that_cannot_be_written_is_an_error) {
  CampaignLog log("", "one");
  EXPECT_NO_THROW(log.append({0, 0}, tally_));
  EXPECT_THROW(CampaignLog(folder_.path(), "one"), InputError);
  EXPECT_THROW(CampaignLog(folder_ / "none/log.jsonl", "one"), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
