// Campaigns in parts: killed and resumed, put together, doubted; each refusal with the twin that passes.
#include <gtest/gtest.h>

#include <algorithm>
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
using Arguments = std::vector<std::string>;

class CampaignParts : public testing::Test {
 protected:
  static constexpr int parts = 8;

  static Arguments joined(Arguments first, const Arguments& rest) {
    first.insert(first.end(), rest.begin(), rest.end());
    return first;
  }
  [[nodiscard]] static Arguments attack(const Arguments& rest, const std::string& samples = "5000") {
    return joined({DELCERT_PROGRAM, "attack", DELCERT_CLAIMS "/circumradius-by-thickness.toml",
                   DELCERT_CLAIMS "/circumradius-below-edge.toml", "--shape", "2,2", "--shape", "5,5", "--seed", "4",
                   "--samples", samples},
                  rest);
  }
  [[nodiscard]] static Arguments campaign(const Arguments& rest) { return joined({DELCERT_PROGRAM, "campaign"}, rest); }
  [[nodiscard]] std::string log(int part) const { return folder_ / ("part-" + std::to_string(part) + ".jsonl"); }
  [[nodiscard]] std::string whole() const { return folder_ / "whole.jsonl"; }
  [[nodiscard]] std::string part_of(int part) const { return std::to_string(part) + "/" + std::to_string(parts); }
  [[nodiscard]] Arguments attack_part(int part, const std::string& samples = "5000") const {
    return attack({"--part", part_of(part), "--log", log(part), "--threads", "1"}, samples);
  }
  [[nodiscard]] Arguments merge(const Arguments& rest = {}) const {
    Arguments result{"merge"};
    for (int part = 1; part <= parts; ++part) result.push_back(log(part));
    return campaign(joined(joined(result, {"--output", whole()}), rest));
  }
  static std::ptrdiff_t lines_of(const std::string& path) {
    const std::string text = content_of(path);
    return std::count(text.begin(), text.end(), '\n');
  }
  static void wait_for_lines(const std::string& path, std::ptrdiff_t lines, Process& process) {
    while (lines_of(path) < lines && !process.has_ended()) std::this_thread::sleep_for(1ms);
  }
  /// Kills it when the log has so many lines.
  void kill_part(int part, std::ptrdiff_t lines) const {
    Process process(attack_part(part), folder_ / "killed");
    wait_for_lines(log(part), lines, process);
    process.send(SIGKILL);
    EXPECT_EQ(process.wait(), -SIGKILL) << process.error();
  }
  void expect(int status, const Arguments& arguments, const std::string& output, const std::string& error) const {
    Process process(arguments, folder_ / "streams");
    EXPECT_EQ(process.wait(), status) << process.output() << process.error();
    EXPECT_NE(process.output().find(output), std::string::npos) << process.output();
    EXPECT_NE(process.error().find(error), std::string::npos) << process.error();
  }
  [[nodiscard]] std::string result_of(const Arguments& arguments) const {
    Process process(arguments, folder_ / "streams");
    EXPECT_EQ(process.wait(), 1) << process.error();
    EXPECT_EQ(process.error(), "");
    return process.output();
  }
  void run_parts(const std::string& samples = "5000") const {
    for (int part = 1; part <= parts; ++part) expect(0, attack_part(part, samples), "blocks are finished in", "");
  }

  delcert::test::TemporaryFolder folder_;
};

TEST_F(CampaignParts, eight_of_them_two_killed_and_resumed_print_what_a_single_run_does) {
  kill_part(3, 5);
  kill_part(6, 4);
  // As if the last line had been cut off.
  fs::resize_file(log(6), fs::file_size(log(6)) - 10);
  expect(2, campaign({"merge", log(3), log(6), "--output", whole()}), "", " is missing, and ");
  EXPECT_FALSE(fs::exists(whole()));
  run_parts();
  expect(0, merge(), "coverage: blocks 0 to 79, each once; 20000 samples\n", "");
  for (const Arguments& format : {Arguments{}, Arguments{"--json"}, Arguments{"--latex"}, Arguments{"--short"}}) {
    const std::string single = result_of(attack(format));
    EXPECT_EQ(result_of(joined(campaign({"table", whole()}), format)), single);
    EXPECT_EQ(result_of(attack(joined({"--log", whole()}, format))), single);
  }
}

TEST_F(CampaignParts, a_missing_block_is_named) {
  run_parts("500");
  expect(0, merge(), "coverage: blocks 0 to 7, each once", "");
  fs::remove(whole());
  // The last line is the only block of the part.
  const std::string text = content_of(log(5));
  fs::resize_file(log(5), text.rfind('\n', text.size() - 2) + 1);
  expect(2, merge(), "", "block ");
  EXPECT_FALSE(fs::exists(whole()));
  expect(2, merge(), "", " is missing; the first is of part 5/8");
  expect(0, attack_part(5, "500"), "part 5/8: 1 of 1 blocks are finished", "");
  expect(0, merge(), "coverage: blocks 0 to 7, each once", "");
}

TEST_F(CampaignParts, overlaps_and_logs_of_other_campaigns_are_refused) {
  run_parts("500");
  expect(1, merge({log(1)}), "", "already");
  const std::string other = folder_ / "other.jsonl";
  auto arguments = attack({"--part", "2/8", "--log", other}, "500");
  std::replace(arguments.begin(), arguments.end(), std::string("4"), std::string("5"));
  expect(0, arguments, "", "");
  Arguments logs{"merge", log(1), other, "--output", whole()};
  expect(3, campaign(logs), "", "other.jsonl:1: the log of another campaign: its seed is 5, not 4");
  expect(3, campaign({"merge", log(1), log(2), "--output", log(2)}), "", "is one of the logs");
  EXPECT_FALSE(fs::exists(whole()));
  expect(0, merge(), "each once", "");
}

TEST_F(CampaignParts, extended_they_print_what_the_longer_run_does) {
  run_parts("1100");
  run_parts("2345");
  expect(0, merge(), "each once", "");
  EXPECT_EQ(result_of(campaign({"table", whole()})), result_of(attack({}, "2345")));
  expect(3, attack_part(1, "1100"), "", "samples can only be added");
}

TEST_F(CampaignParts, two_processes_do_not_write_to_one_log) {
  Process first(attack({"--log", whole()}, "10000000"), folder_ / "first");
  wait_for_lines(whole(), 3, first);
  ASSERT_FALSE(first.has_ended()) << first.error();
  const std::string id = "process " + std::to_string(first.id()) + " on ";
  expect(3, attack({"--log", whole()}, "10000000"), "", whole() + ": " + id);
  expect(3, campaign({"merge", whole(), "--output", folder_ / "merged.jsonl"}), "", "a process writes to this log");
  expect(0, campaign({"status", whole()}), "0 of 1 logs finished, 1 running, 0 stopped", "");
  expect(0, campaign({"status", whole(), "--json"}), "\"state\": \"running\"", "");
  first.send(SIGKILL);
  EXPECT_EQ(first.wait(), -SIGKILL);
  // The lock ends with the process.
  expect(0, campaign({"status", whole()}), "0 running, 1 stopped", "");
}

TEST_F(CampaignParts, a_time_limit_ends_after_a_whole_block_and_says_that_it_was_not_all) {
  const Arguments limited = attack({"--log", whole(), "--until", "2s", "--progress-every", "1s"}, "10000000");
  Process process(limited, folder_ / "limited");
  EXPECT_EQ(process.wait(), 2);
  EXPECT_EQ(process.output(), "");
  EXPECT_NE(process.error().find("attack: "), std::string::npos) << process.error();
  EXPECT_NE(process.error().find(" blocks after 2s; the same command goes on from them, in " + whole()),
            std::string::npos)
      << process.error();
  EXPECT_TRUE(content_of(whole()).ends_with("\"}\n"));
  const auto lines = lines_of(whole());
  EXPECT_GT(lines, 2);
  expect(2, limited, "", "not finished");
  EXPECT_GT(lines_of(whole()), lines);
  expect(2, campaign({"table", whole()}), "", " is missing, and ");
}

TEST_F(CampaignParts, recheck_finds_what_a_log_says_falsely) {
  run_parts("500");
  expect(0, merge(), "", "");
  expect(0, campaign({"recheck", whole(), "--share", "1"}), "8 of 8 blocks rechecked are as the log says", "");
  expect(0, campaign({"recheck", whole()}), "1 of 1 blocks rechecked are as the log says, of 8 in all", "");
  // A forger who computes all sums anew.
  const std::string forged = folder_ / "forged.jsonl";
  const std::string script =
      "import hashlib, json, sys\n"
      "last = ''\n"
      "with open(sys.argv[2], 'w') as out:\n"
      "  for line in open(sys.argv[1]):\n"
      "    line = json.loads(line)\n"
      "    del line['sum']\n"
      "    if line.get('target') == 0 and line['first'] == 0:\n"
      "      line['tally']['conclusions'][0]['held'] -= 1\n"
      "      line['tally']['conclusions'][0]['undecided'] += 1\n"
      "    text = json.dumps(line, separators=(',', ':'), ensure_ascii=False)\n"
      "    last = hashlib.sha256((last + text).encode()).hexdigest()\n"
      "    out.write(text[:-1] + ',\"sum\":\"' + last + '\"}\\n')\n";
  Process forger({"/usr/bin/env", "python3", "-c", script, whole(), forged}, folder_ / "forger");
  ASSERT_EQ(forger.wait(), 0) << forger.error();
  expect(1, campaign({"recheck", forged, "--share", "1"}), "forged.jsonl:3: block 0 (", "");
  expect(1, campaign({"recheck", forged, "--share", "1"}), "7 of 8 blocks rechecked are as the log says", "");
}

}  // namespace
