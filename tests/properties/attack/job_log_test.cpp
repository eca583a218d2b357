#include "properties/attack/job_log.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;

// What crashes and strangers do to it is tested with the log of a campaign, campaign_log_test.cpp.
class JobLogFile : public testing::Test {
 protected:
  std::vector<Json> lines(const std::string& what, const std::string& identity) const {
    std::vector<Json> result;
    const JobLog log(path_, what, identity, [&](const Json& line) { result.push_back(line); });
    return result;
  }
  std::string error_of(const std::string& what, const std::string& identity, const JobLog::ReadLine& read) const {
    try {
      const JobLog log(path_, what, identity, read);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "log.jsonl";
};

TEST_F(JobLogFile, lines_come_back_in_their_order) {
  const auto none = [](const Json&) { FAIL(); };
  {
    JobLog log(path_, "search", "one", none);
    log.append({{"a", 1}});
    log.append({{"a", 2}});
  }
  EXPECT_EQ(lines("search", "one"), (std::vector<Json>{{{"a", 1}}, {{"a", 2}}}));
}

TEST_F(JobLogFile, other_work_or_another_identity_is_refused_by_name) {
  const auto any = [](const Json&) {};
  { const JobLog log(path_, "search", "one", any); }
  EXPECT_EQ(error_of("search", "one", any), "no error");
  EXPECT_NE(error_of("search", "two", any).find("log.jsonl:1: the log of another search"), std::string::npos);
  EXPECT_NE(error_of("campaign", "one", any).find("log.jsonl:1: not a line of the log of a campaign"),
            std::string::npos);
}

TEST_F(JobLogFile, what_the_reader_refuses_is_named_with_its_line) {
  const auto any = [](const Json&) {};
  {
    JobLog log(path_, "search", "one", any);
    log.append({{"a", 1}});
    log.append({{"b", 1}});
  }
  EXPECT_NE(error_of("search", "one", [](const Json& line) { (void)line.at("a"); }).find("log.jsonl:3: "),
            std::string::npos);
  EXPECT_NE(error_of("search", "one", [](const Json&) { throw InputError("no good"); }).find("log.jsonl:2: no good"),
            std::string::npos);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
