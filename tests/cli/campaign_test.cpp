// Campaigns of `delcert attack` that are killed or interrupted and go on from their log, and with more threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

using delcert::test::content_of;
using delcert::test::Process;

class Campaign : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> command(const std::string& threads) const {
    return {DELCERT_PROGRAM,
            "attack",
            DELCERT_CLAIMS "/circumradius-by-thickness.toml",
            DELCERT_CLAIMS "/circumradius-below-edge.toml",
            "--samples",
            "2500",
            "--shape",
            "2,2",
            "--shape",
            "3,3",
            "--seed",
            "4",
            "--json",
            "--threads",
            threads};
  }
  [[nodiscard]] std::vector<std::string> logged(const std::string& threads) const {
    auto result = command(threads);
    result.insert(result.end(), {"--log", log().string()});
    return result;
  }
  [[nodiscard]] fs::path log() const { return folder_ / "log.jsonl"; }

  [[nodiscard]] fs::path streams() const { return folder_ / "streams"; }
  /// Runs until the log has so many lines, then sends the signal; the exit status.
  [[nodiscard]] int run_until(std::ptrdiff_t lines, int signal) const {
    Process process(logged("2"), streams());
    for (int waited = 0; waited < 60000; ++waited) {
      const std::string text = content_of(log());
      if (std::count(text.begin(), text.end(), '\n') >= lines) break;
      std::this_thread::sleep_for(1ms);
    }
    process.send(signal);
    return process.wait();
  }
  [[nodiscard]] std::string error() const { return content_of(streams() / "error"); }
  [[nodiscard]] std::string output() const { return content_of(streams() / "output"); }
  /// Exit status 1, the false claim is refuted; what was printed.
  [[nodiscard]] std::string result_of(const std::vector<std::string>& arguments) const {
    Process process(arguments, streams());
    EXPECT_EQ(process.wait(), 1) << process.error();
    return process.output();
  }

  delcert::test::TemporaryFolder folder_;
};

TEST_F(Campaign, one_thread_and_two_print_the_same) {
  const std::string one = result_of(command("1"));
  EXPECT_NE(one.find("\"refutations\""), std::string::npos);
  EXPECT_EQ(result_of(command("2")), one);
}

TEST_F(Campaign, killed_and_resumed_it_prints_what_an_uninterrupted_one_does) {
  const std::string uninterrupted = result_of(command("1"));
  for (const std::ptrdiff_t lines : {2, 9, 20}) EXPECT_EQ(run_until(lines, SIGKILL), -SIGKILL);
  // As if the last line had been cut off.
  const std::string text = content_of(log());
  fs::resize_file(log(), text.size() - 10);
  EXPECT_EQ(result_of(logged("2")), uninterrupted);
  const std::string whole = content_of(log());
  EXPECT_EQ(result_of(logged("1")), uninterrupted);
  EXPECT_EQ(content_of(log()), whole) << "what was finished is not done again";
}

TEST_F(Campaign, interrupted_it_says_where_it_goes_on_and_does) {
  const std::string uninterrupted = result_of(command("1"));
  EXPECT_EQ(run_until(3, SIGINT), 130);
  EXPECT_NE(error().find("goes on from what is finished in " + log().string()), std::string::npos);
  EXPECT_EQ(output(), "");
  EXPECT_EQ(result_of(logged("2")), uninterrupted);
}

TEST_F(Campaign, the_log_of_another_campaign_is_refused) {
  (void)result_of(logged("2"));
  auto other = logged("2");
  std::replace(other.begin(), other.end(), std::string("4"), std::string("5"));
  EXPECT_EQ(Process(other, streams()).wait(), 3);
  EXPECT_NE(error().find("log.jsonl:1: the log of another campaign: its seed is 4, not 5"), std::string::npos)
      << error();
}

TEST_F(Campaign, extended_by_samples_it_prints_what_the_longer_run_does) {
  (void)result_of(logged("2"));
  const auto with_samples = [](std::vector<std::string> arguments, const std::string& samples) {
    std::replace(arguments.begin(), arguments.end(), std::string("2500"), samples);
    return arguments;
  };
  EXPECT_EQ(result_of(with_samples(logged("2"), "3333")), result_of(with_samples(command("2"), "3333")));
  EXPECT_EQ(Process(logged("2"), streams()).wait(), 3);
  EXPECT_NE(error().find("samples can only be added"), std::string::npos) << error();
}

}  // namespace
