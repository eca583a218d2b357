// Campaigns of `delcert attack` that are killed or interrupted and go on from their log, and with more threads.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

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
  [[nodiscard]] fs::path output() const { return folder_ / "output"; }

  [[nodiscard]] ::pid_t start(std::vector<std::string> arguments) const {
    const ::pid_t id = ::fork();
    if (id != 0) return id;
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    if (std::freopen(output().c_str(), "w", stdout) == nullptr) ::_exit(126);
    if (std::freopen((folder_ / "error").c_str(), "w", stderr) == nullptr) ::_exit(126);
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }
  /// The exit status, or minus the signal that ended it.
  static int status_of(::pid_t id) {
    int status = 0;
    ::waitpid(id, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  /// Runs until the log has so many lines, then sends the signal; the exit status.
  [[nodiscard]] int run_until(std::ptrdiff_t lines, int signal) const {
    const ::pid_t id = start(logged("2"));
    for (int waited = 0; waited < 60000; ++waited) {
      const std::string text = content_of(log());
      if (std::count(text.begin(), text.end(), '\n') >= lines) break;
      std::this_thread::sleep_for(1ms);
    }
    ::kill(id, signal);
    return status_of(id);
  }
  /// Exit status 1, the false claim is refuted; what was printed.
  [[nodiscard]] std::string result_of(const std::vector<std::string>& arguments) const {
    EXPECT_EQ(status_of(start(arguments)), 1) << content_of(folder_ / "error");
    return content_of(output());
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
  EXPECT_NE(content_of(folder_ / "error").find("goes on from what is finished in " + log().string()),
            std::string::npos);
  EXPECT_EQ(content_of(output()), "");
  EXPECT_EQ(result_of(logged("2")), uninterrupted);
}

TEST_F(Campaign, the_log_of_another_campaign_is_refused) {
  (void)result_of(logged("2"));
  auto other = logged("2");
  std::replace(other.begin(), other.end(), std::string("2500"), std::string("2501"));
  EXPECT_EQ(status_of(start(other)), 3);
  EXPECT_NE(content_of(folder_ / "error").find("log.jsonl:1: the log of another campaign"), std::string::npos);
}

}  // namespace
