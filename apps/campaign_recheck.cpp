#include "properties/attack/campaign_recheck.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>

#include "apps/campaign_commands.hpp"
#include "apps/campaign_options.hpp"
#include "apps/interruption.hpp"
#include "apps/progress_line.hpp"
#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct RecheckOptions {
  std::string log;
  std::string share = "1/100";
  std::optional<std::uint64_t> seed;
  unsigned threads = 0;
  bool json = false;
};

/// At least one, and all for 1.
std::uint64_t count_from(const std::string& share, std::size_t blocks) {
  try {
    const Rational value = parse_exact(share);
    if (value > 0 && value <= 1) {
      return ceiling_of(value * Rational(static_cast<unsigned long>(blocks))).convert_to<std::uint64_t>();
    }
  } catch (const ExactTextError& error) {
    throw InputError("--share " + std::string(error.what()));
  }
  throw InputError("--share " + share + ": a number above 0 and at most 1 was expected, such as 1/100");
}

/// Nobody is to know before which blocks will be looked at.
std::uint64_t unforeseen_seed() {
  std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32U) | device();
}

ExitStatus run_recheck(const RecheckOptions& options) {
  const CampaignRecord log = read_campaign(options.log);
  const std::size_t blocks = log.finished.size();
  if (blocks == 0) throw InputError(options.log + ": no block is finished");
  if (log.plan.software != software_name()) {
    throw InputError(options.log + ":1: made by " + log.plan.software + ", and this is " + software_name());
  }
  const std::uint64_t count = count_from(options.share, blocks);
  const std::uint64_t seed = options.seed ? *options.seed : unforeseen_seed();
  const InterruptionDeadline deadline;
  ProgressLine line;
  const std::vector<std::string> differences =
      recheck(log, drawn_blocks(log, count, seed), threads_or_all(options.threads), line.callback());
  line.clear();
  const std::uint64_t noticeable = approximate_noticeable_blocks(blocks, count);
  if (options.json) {
    std::cout << nlohmann::ordered_json{{"blocks", blocks},
                                        {"rechecked", count},
                                        {"seed", seed},
                                        {"differences", differences},
                                        {"noticeable_blocks", noticeable}}
                     .dump(1)
              << "\n";
  } else {
    for (const std::string& text : differences) std::cout << text << "\n";
    std::cout << count - differences.size() << " of " << count << " blocks rechecked are as the log says, of " << blocks
              << " in all (--seed " << seed << ")\n";
    if (differences.empty() && count < blocks) {
      std::cout << "if " << noticeable
                << " of them or more were false, one would have been drawn with probability 95 %\n";
    }
  }
  return differences.empty() ? ExitStatus::verified : ExitStatus::rejected;
}

}  // namespace

void add_campaign_recheck(CLI::App& campaign, Action& chosen) {
  const auto options = std::make_shared<RecheckOptions>();
  CLI::App* command = campaign.add_subcommand("recheck", "Attack some blocks of a log anew, and compare");
  command->add_option("log", options->log, "A log of delcert attack, or of delcert campaign merge")->required();
  command->add_option("--share", options->share, "Share of the blocks, 1 for all (default 1/100; at least one block)");
  command->add_option("--seed", options->seed, "Which blocks are drawn (default: nobody knows before)");
  command->add_option("--threads", options->threads, "Threads (default: all; the result does not depend on it)");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Exit status: 0 all blocks that were drawn are as the log says, 1 some are not.\n\n"
      "Examples:\n"
      "  delcert campaign recheck whole.jsonl\n"
      "  delcert campaign recheck whole.jsonl --share 1");
  command->callback([options, &chosen] { chosen = [options] { return run_recheck(*options); }; });
}

}  // namespace delcert
