#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
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

constexpr const char* old_content = "what was there before";
constexpr const char* message = "delcert: error: interrupted; nothing was written\n";
constexpr int interrupted = 130;

/// A folder for the certificate and for nothing else, with an old file in the certificate's place.
class InterruptedRun : public ::testing::Test {
 protected:
  void SetUp() override { begin_anew(); }

  void begin_anew() const {
    fs::remove_all(folder());
    fs::create_directory(folder());
    std::ofstream(certificate()) << old_content;
  }
  [[nodiscard]] fs::path folder() const { return root / "certificates"; }
  [[nodiscard]] fs::path certificate() const { return folder() / "torus.json"; }
  [[nodiscard]] Process certify(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {DELCERT_PROGRAM, "certify"});
    arguments.insert(arguments.end(), {"--output", certificate().string()});
    return {arguments, root / "streams"};
  }
  /// Some 50 000 points: it computes for longer than any of the tests waits.
  [[nodiscard]] Process long_run() const { return certify({"--manifold", "torus-3", "--radius", "1/40"}); }
  /// Some seconds at most, of which the last part goes into writing more than a megabyte.
  [[nodiscard]] Process short_run() const {
    return certify({"--manifold", "torus-2", "--radius", "1/100", "--mode", "measured", "--levels", "0,1,2"});
  }
  [[nodiscard]] int check(const fs::path& path) const {
    return Process({DELCERT_CHECKER, path.string()}, root / "streams").wait();
  }

  [[nodiscard]] std::vector<fs::path> other_files() const {
    std::vector<fs::path> result;
    for (const auto& entry : fs::directory_iterator(folder())) {
      if (entry.path() != certificate()) result.push_back(entry.path());
    }
    return result;
  }
  [[nodiscard]] bool holds_what_was_there_before() const { return content_of(certificate()) == old_content; }
  void expect_nothing_but_the_old_file() const {
    EXPECT_TRUE(holds_what_was_there_before());
    EXPECT_TRUE(other_files().empty()) << other_files().front();
  }
  /// Signals the program as soon as a file beside the old one shows that it writes.
  void send_while_it_writes(Process& process, int signal) const {
    while (other_files().empty() && !process.has_ended()) std::this_thread::sleep_for(100us);
    process.send(signal);
  }

  delcert::test::TemporaryFolder root;
};

TEST_F(InterruptedRun, without_a_signal_replaces_the_old_file_by_a_certificate) {
  Process process = short_run();
  EXPECT_EQ(process.wait(), 0) << process.error();
  EXPECT_TRUE(other_files().empty());
  EXPECT_EQ(check(certificate()), 0);
}

TEST_F(InterruptedRun, leaves_the_old_file_and_no_other_whenever_the_signal_comes) {
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const auto after : {0ms, 300ms, 1000ms, 2000ms, 5000ms}) {
      Process process = long_run();
      process.wait_until_it_catches(signal);
      std::this_thread::sleep_for(after);
      process.send(signal);
      EXPECT_EQ(process.wait(), interrupted) << "signal " << signal << " after " << after.count() << " ms";
      EXPECT_EQ(process.error(), message);
      EXPECT_TRUE(process.output().empty());
      expect_nothing_but_the_old_file();
    }
  }
}

TEST_F(InterruptedRun, leaves_no_new_file_where_there_was_none) {
  fs::remove(certificate());
  Process process = long_run();
  process.wait_until_it_catches(SIGINT);
  process.send(SIGINT);
  EXPECT_EQ(process.wait(), interrupted);
  EXPECT_TRUE(fs::is_empty(folder()));
}

// The signal may come too late: then, and only then, there is the whole certificate.
TEST_F(InterruptedRun, leaves_the_old_file_and_no_other_when_interrupted_while_it_writes) {
  for (const int signal : {SIGINT, SIGTERM}) {
    int stopped = 0;
    for (int attempt = 0; attempt < 10 && stopped == 0; ++attempt) {
      begin_anew();
      Process process = short_run();
      send_while_it_writes(process, signal);
      const int status = process.wait();
      if (status == 0) {
        EXPECT_EQ(check(certificate()), 0);
        continue;
      }
      ++stopped;
      EXPECT_EQ(status, interrupted);
      EXPECT_EQ(process.error(), message);
      expect_nothing_but_the_old_file();
    }
    EXPECT_EQ(stopped, 1) << "signal " << signal;
  }
}

TEST_F(InterruptedRun, leaves_the_old_file_when_killed_while_it_computes) {
  for (const auto after : {300ms, 1000ms, 2000ms}) {
    Process process = long_run();
    std::this_thread::sleep_for(after);
    process.send(SIGKILL);
    EXPECT_EQ(process.wait(), -SIGKILL);
    expect_nothing_but_the_old_file();
  }
}

// Killed too late, between the last byte and the renaming, it would leave a whole certificate.
TEST_F(InterruptedRun, killed_while_it_writes_leaves_no_certificate_and_does_not_hinder_the_next) {
  ASSERT_EQ(short_run().wait(), 0);
  const std::string whole = content_of(certificate());
  std::vector<fs::path> rest;
  for (int attempt = 0; attempt < 10 && rest.empty(); ++attempt) {
    begin_anew();
    Process process = short_run();
    send_while_it_writes(process, SIGKILL);
    if (process.wait() != -SIGKILL) continue;
    rest = other_files();
    if (!rest.empty() && content_of(rest[0]) == whole) rest.clear();
  }
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_TRUE(holds_what_was_there_before());
  EXPECT_NE(rest[0].extension(), ".json");
  EXPECT_NE(rest[0].extension(), ".zst");
  EXPECT_EQ(check(rest[0]), 3);

  Process next = short_run();
  EXPECT_EQ(next.wait(), 0) << next.error();
  EXPECT_TRUE(content_of(certificate()) == whole);
}

/// One instance of which one conclusion is a hundred thousand ties, each of them decided by algebraic numbers: nothing
/// asks in between whether the program is to end.
TEST(InterruptedAttack, ends_in_the_middle_of_a_decision_that_takes_long) {
  const delcert::test::TemporaryFolder root;
  const fs::path claim = root / "tie.toml";
  std::ofstream(claim) << "name = 'tie'\ninstance = 'simplex'\n[[show]]\nclaim = 'forall i in 1..100000: "
                          "sqrt(i + edge(s, 0, 1)^2) + sqrt(i + 1) + sqrt(i + 2) + sqrt(i + 3) = "
                          "sqrt(i + 3) + sqrt(i + 2) + sqrt(i + 1) + sqrt(i + edge(s, 0, 1)^2)'\n";
  for (const int signal : {SIGINT, SIGTERM}) {
    for (const std::string& log : {std::string(), (root / "log.jsonl").string()}) {
      std::vector<std::string> arguments{DELCERT_PROGRAM, "attack", claim.string(), "--shape", "2,2", "--threads", "1"};
      if (!log.empty()) arguments.insert(arguments.end(), {"--log", log});
      Process process(arguments, root / "streams");
      process.wait_until_it_catches(signal);
      std::this_thread::sleep_for(2s);
      ASSERT_FALSE(process.has_ended()) << "the tie is no long one: " << process.output() << process.error();
      const auto begin = std::chrono::steady_clock::now();
      process.send(signal);
      EXPECT_EQ(process.wait(), interrupted);
      EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
      EXPECT_EQ(process.error(), log.empty() ? std::string(message)
                                             : "delcert: error: interrupted; the same command goes on from what is "
                                               "finished in " +
                                                   log + "\n");
    }
  }
}

}  // namespace
