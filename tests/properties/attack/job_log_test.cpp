#include "properties/attack/job_log.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "support/error.hpp"
#include "support/host.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;

// What crashes and strangers do to it is tested with the log of a campaign, campaign_log_test.cpp.
class JobLogFile : public testing::Test {
 protected:
  std::vector<Json> lines(const std::string& what, const std::string& identity) const {
    std::vector<Json> result;
    const JobLog log(path_, what, identity, [&](const Json& line, std::size_t) { result.push_back(line); });
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
  const auto none = [](const Json&, std::size_t) { FAIL(); };
  {
    JobLog log(path_, "search", "one", none);
    log.append({{"a", 1}});
    log.append({{"a", 2}});
  }
  EXPECT_EQ(lines("search", "one"), (std::vector<Json>{{{"a", 1}}, {{"a", 2}}}));
}

TEST_F(JobLogFile, other_work_or_another_identity_is_refused_by_name) {
  const auto any = [](const Json&, std::size_t) {};
  { const JobLog log(path_, "search", "one", any); }
  EXPECT_EQ(error_of("search", "one", any), "no error");
  EXPECT_NE(error_of("search", "two", any).find("log.jsonl:1: the log of another search"), std::string::npos);
  EXPECT_NE(error_of("campaign", "one", any).find("log.jsonl:1: not a line of the log of a campaign"),
            std::string::npos);
}

TEST_F(JobLogFile, what_the_reader_refuses_is_named_with_its_line) {
  const auto any = [](const Json&, std::size_t) {};
  {
    JobLog log(path_, "search", "one", any);
    log.append({{"a", 1}});
    log.append({{"b", 1}});
  }
  EXPECT_NE(error_of("search", "one", [](const Json& line, std::size_t) { (void)line.at("a"); }).find("log.jsonl:4: "),
            std::string::npos);
  EXPECT_NE(error_of("search", "one", [](const Json&, std::size_t) { throw InputError("no good"); })
                .find("log.jsonl:3: no good"),
            std::string::npos);
}

TEST_F(JobLogFile, tells_readers_which_processes_wrote_to_it) {
  const auto any = [](const Json&, std::size_t) {};
  for (int round = 0; round < 2; ++round) {
    JobLog log(path_, "search", "one", any);
    log.append({{"a", round}});
    log.append({{"a", round}});
  }
  { const JobLog idle(path_, "search", "one", any); }
  const JobLogContents contents = read_job_log(path_, "search", any, any);
  ASSERT_EQ(contents.writers.size(), 2U);
  EXPECT_EQ(contents.writers[1].process, ::getpid());
  EXPECT_EQ(contents.writers[1].host, host_name());
  EXPECT_EQ(contents.file.lines, 7U);
  EXPECT_EQ(contents.sum.size(), 64U);
}

TEST_F(JobLogFile, one_process_at_a_time_writes_to_it_and_is_named) {
  const auto any = [](const Json&, std::size_t) {};
  EXPECT_FALSE(is_being_written(path_));
  {
    JobLog log(path_, "search", "one", any);
    EXPECT_TRUE(is_being_written(path_));
    EXPECT_NE(error_of("search", "one", any).find("log.jsonl: another process writes to this log"), std::string::npos);
    log.begin();
    const std::string error = error_of("search", "one", any);
    EXPECT_NE(error.find("log.jsonl: process " + std::to_string(::getpid()) + " on " + host_name() + ", since "),
              std::string::npos)
        << error;
    EXPECT_TRUE(error.ends_with(", writes to this log")) << error;
    log.append({{"a", 1}});
  }
  EXPECT_FALSE(is_being_written(path_));
  EXPECT_EQ(lines("search", "one").size(), 1U);
}

TEST_F(JobLogFile, that_cannot_be_read_is_an_error) {
  const auto any = [](const Json&, std::size_t) {};
  EXPECT_THROW((void)read_job_log(path_, "search", any, any), InputError);
  EXPECT_THROW((void)read_job_log(folder_.path(), "search", any, any), InputError);
  { const std::ofstream empty(path_); }
  EXPECT_THROW((void)read_job_log(path_, "search", any, any), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
