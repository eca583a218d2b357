// Work that is divided among processes has the outcome of work in one.

#include "proofs/checker/parts/parts.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "proofs/checker/arithmetic/decide.hpp"
#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/samples.hpp"
#include "tests/checker/support/space_form_samples.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

struct Outcome {
  checker::Counts counts{};
  std::vector<std::string> findings;
  std::uint64_t filtered = 0, left = 0;
  std::string exception;
  bool operator==(const Outcome&) const = default;
};

/// 1000 numbers, of which some break rules, and one of which may throw.
Outcome outcome_of(unsigned parts, std::uint64_t budget, std::size_t thrower, bool dies_elsewhere) {
  checker::most_parts = parts;
  checker::Budget::open(0);
  checker::Budget::spend(checker::Budget::left() - budget);
  checker::decisions = {};
  const pid_t here = ::getpid();
  checker::Report report;
  report.reject("rule.early", [] { return "before"; });
  Outcome outcome;
  try {
    outcome.counts =
        checker::in_parts("rule.300", 1000, report, [&](std::size_t begin, std::size_t end, checker::Report& found) {
          checker::Counts counts{};
          // So that others take blocks, too, and get to number 700.
          if (parts > 1 && ::getpid() == here) std::this_thread::sleep_for(std::chrono::milliseconds(5));
          for (std::size_t k = begin; k < end; ++k) {
            if (k == thrower) throw checker::Undecided("at " + std::to_string(k));
            if (k == 700 && dies_elsewhere && ::getpid() != here) std::raise(SIGKILL);
            checker::decide([]<class N>(checker::In<N>) { return checker::Verdict::proved; });
            ++counts[0];
            counts[1] += static_cast<std::int64_t>(k);
            const auto say = [&] { return "number " + std::to_string(k); };
            if (k % 300 == 299) found.reject("rule.300", say);
            if (k % 500 == 499) found.reject("rule.500", say);
            if (k % 400 == 399) found.reject("rule.early", say);
          }
          return counts;
        });
  } catch (const checker::Undecided& reason) {
    outcome.exception = reason.what();
  }
  checker::most_parts = 1;
  for (const checker::Finding& finding : report.findings) outcome.findings.push_back(finding.rule + finding.what);
  outcome.filtered = checker::decisions.filtered;
  outcome.left = checker::Budget::left();
  checker::Budget::open(0);
  return outcome;
}

/// Then what the processes have found out is all there is. Half of the times they die when they meet a number.
TEST(Parts, look_at_each_number_once_where_nothing_is_wrong) {
  const test::Upwards upwards;
  const pid_t here = ::getpid();
  for (const unsigned parts : {1U, 2U, 3U, 5U}) {
    for (const std::size_t size : {63U, 64U, 129U, 1000U}) {
      const std::size_t mortal = size % 2 == 0 ? size / 2 : size;
      checker::most_parts = parts;
      checker::decisions = {};
      checker::Report report;
      const checker::Counts counts = checker::in_parts(
          "rule", size, report,
          [&](std::size_t begin, std::size_t end, checker::Report& /*found*/) {
            checker::Counts sum{};
            if (parts > 1 && ::getpid() == here) std::this_thread::sleep_for(std::chrono::milliseconds(5));
            for (std::size_t k = begin; k < end; ++k) {
              if (k == mortal && ::getpid() != here) std::raise(SIGKILL);
              checker::decide([]<class N>(checker::In<N>) { return checker::Verdict::proved; });
              ++sum[0];
              sum[1] += static_cast<std::int64_t>(k * k);
            }
            return sum;
          },
          {}, 8);
      checker::most_parts = 1;
      const auto n = static_cast<std::int64_t>(size);
      EXPECT_EQ(counts, (checker::Counts{n, (n - 1) * n * (2 * n - 1) / 6})) << parts << " of " << size;
      EXPECT_EQ(checker::decisions.filtered, size);
    }
  }
}

TEST(Parts, have_the_outcome_of_the_whole) {
  const test::Upwards upwards;
  constexpr std::size_t none = 5000;
  for (const auto& [budget, thrower] : {std::pair<std::uint64_t, std::size_t>(100000, none),
                                        {100000, 350},
                                        {100000, 900},
                                        {1000, none},
                                        {999, none},
                                        {600, none},
                                        {600, 350}}) {
    const Outcome whole = outcome_of(1, budget, thrower, false);
    EXPECT_EQ(whole.exception.empty(), thrower == none && budget >= 1000);
    EXPECT_EQ(whole.findings.size(), 3U - (thrower == 350 ? 1U : 0U));
    for (const unsigned parts : {2U, 3U, 7U, 1000U}) {
      for (const bool dies : {false, true})
        EXPECT_EQ(outcome_of(parts, budget, thrower, dies), whole) << parts << " " << budget << " " << thrower;
    }
  }
}

TEST(Parts, of_any_size_cover_what_there_is_once) {
  for (const std::uint64_t size :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1000}, (std::uint64_t{1} << 40) + 7}) {
    for (const std::uint64_t of : {1U, 2U, 7U, 1001U, 1000000U}) {
      std::uint64_t covered = 0, longest = 0;
      for (std::uint64_t number = 1; number <= of; ++number) {
        const auto [begin, end] = checker::range_of({number, of}, size);
        ASSERT_EQ(begin, covered);
        covered = end;
        longest = std::max(longest, end - begin);
      }
      EXPECT_EQ(covered, size) << of;
      EXPECT_LE(longest, size / of + 1) << of;
    }
  }
  // Halves of a share are shares.
  EXPECT_EQ(checker::range_of({2, 3}, 1000).second, checker::range_of({4, 6}, 1000).second);
}

/// What the checker says, but for how long it took.
std::string said(const std::string& file, int parts) {
  const CheckerRun run = run_checker_with(file + " --json --threads " + std::to_string(parts));
  auto json = nlohmann::json::parse(run.output);
  for (auto& level : json["levels"]) level.erase("seconds");
  return std::to_string(run.status) + json.dump();
}

TEST(Parts, of_a_check_say_what_the_whole_says) {
  std::vector<std::string> documents = {sealed(cubic_torus().document()), sealed(bolza_surface().document()),
                                        sealed(projective_space().document()),
                                        sealed(unstable_bolza_surface().document())};
  std::size_t number = 0;
  for (const auto make :
       {level_0_forgeries, star_forgeries, core_forgeries, configuration_forgeries, space_form_forgeries}) {
    for (const Forgery& forgery : made_once(make)) {
      if (number++ % 4 == 0) documents.push_back(forgery.bytes);
    }
  }
  std::size_t rejected = 0;
  for (const std::string& bytes : documents) {
    const std::string file = temporary_file(bytes);
    const std::string whole = said(file, 1);
    rejected += whole.front() == '1' ? 1U : 0U;
    EXPECT_EQ(said(file, 2), whole);
    EXPECT_EQ(said(file, 3), whole);
  }
  EXPECT_GT(rejected, 10U);
}

TEST(Parts, are_at_least_one) {
  const std::string file = temporary_file(sealed(circle().document()));
  for (const char* wrong : {"0", "-1", "x"})
    EXPECT_EQ(run_checker_with(file + " --threads " + wrong).status, 64) << wrong;
}

}  // namespace
}  // namespace delcert::checker_tests
