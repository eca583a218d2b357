#include "properties/attack/campaign_merge.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/campaign_commands.hpp"
#include "apps/campaign_options.hpp"
#include "apps/claim_options.hpp"
#include "apps/interruption.hpp"
#include "apps/progress_line.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct MergeOptions {
  std::vector<std::string> logs;
  std::string output;
  unsigned threads = 0;
  bool json = false;
};

/// The logs that are there already when they are read are not written: a block that is finished meanwhile would be
/// missing, and nobody would know why.
std::vector<CampaignRecord> read_all(const MergeOptions& options) {
  std::vector<CampaignRecord> result;
  for (const std::string& path : options.logs) {
    std::error_code unknown;
    if (std::filesystem::equivalent(path, options.output, unknown)) {
      throw InputError("--output " + options.output + " is one of the logs");
    }
    if (is_being_written(path)) throw InputError(path + ": a process writes to this log; wait until it has ended");
    result.push_back(read_campaign(path));
    throw_if_interrupted();
  }
  return result;
}

std::uint64_t samples_of(const CampaignRecord& log) {
  std::uint64_t result = 0;
  for (const auto& [block, record] : log.finished) result += record.tally.samples;
  return result;
}

std::vector<std::string> hosts_of(const CampaignRecord& log) {
  std::set<std::string> result;
  for (const auto& [block, record] : log.finished) result.insert(record.host);
  return {result.begin(), result.end()};
}

/// What follows from merged() not having thrown, counted anew from what it returned.
std::string coverage_text(const MergedCampaign& campaign, const std::vector<CampaignRecord>& logs) {
  std::string result;
  std::uint64_t number = 0;
  std::uint64_t samples = 0;
  for (const Target& target : campaign.plan.targets) {
    const std::uint64_t blocks = block_count(campaign.plan, target);
    if (blocks == 0) continue;
    result += fmt::format("{} {}: blocks {} to {}, samples 0 to {}\n", target.claim.name, text_of(target.shape), number,
                          number + blocks - 1, target.samples - 1);
    number += blocks;
    samples += target.samples;
  }
  for (const CampaignRecord& log : logs) {
    result += fmt::format("{}: part {}, {} blocks, {} samples\n", log.path.string(), text_of(log.plan.part),
                          log.finished.size(), samples_of(log));
  }
  result += fmt::format("coverage: blocks 0 to {}, each once; {} samples\n", number - 1, samples);
  return result;
}

nlohmann::ordered_json coverage_json(const MergedCampaign& campaign, const std::vector<CampaignRecord>& logs) {
  nlohmann::ordered_json result{{"campaign", digest_of(campaign.plan)}, {"blocks", campaign.finished.size()}};
  result["targets"] = nlohmann::ordered_json::array();
  std::uint64_t number = 0;
  for (const Target& target : campaign.plan.targets) {
    const std::uint64_t blocks = block_count(campaign.plan, target);
    result["targets"].push_back({{"claim", target.claim.name},
                                 {"k", target.shape.k},
                                 {"m", target.shape.m},
                                 {"first_block", number},
                                 {"blocks", blocks},
                                 {"samples", target.samples}});
    number += blocks;
  }
  result["logs"] = nlohmann::ordered_json::array();
  for (const CampaignRecord& log : logs) {
    result["logs"].push_back({{"file", log.path.string()},
                              {"part", {log.plan.part.number, log.plan.part.of}},
                              {"blocks", log.finished.size()},
                              {"samples", samples_of(log)},
                              {"hosts", hosts_of(log)},
                              {"torn", log.is_torn},
                              {"sum", log.sum}});
  }
  return result;
}

ExitStatus run_merge(const MergeOptions& options) {
  const std::vector<CampaignRecord> logs = read_all(options);
  const MergedCampaign campaign = merged(logs);
  if (campaign.finished.empty()) throw Undecided("the campaign has no blocks");
  ProgressLine line;
  {
    const InterruptionDeadline deadline;
    decide_anew(options.output, campaign.plan, campaign.finished, threads_or_all(options.threads), line.callback());
  }
  line.clear();
  write_file_atomically(options.output, merged_text(campaign, logs));
  std::cout << (options.json ? coverage_json(campaign, logs).dump(1) + "\n" : coverage_text(campaign, logs));
  return ExitStatus::verified;
}

}  // namespace

void add_campaign_merge(CLI::App& campaign, Action& chosen) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App* command =
      campaign.add_subcommand("merge", "Put the logs of parts together, and prove that nothing is missing");
  command->add_option("logs", options->logs, "Logs of delcert attack --part")->required();
  command->add_option("--output", options->output, "The log of the whole campaign")->required();
  command->add_option("--threads", options->threads, "Threads (default: all; the result does not depend on it)");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Exit status: 0 every block is there once, and what the table will rest on was decided anew; 1 a block is in "
      "two\n"
      "logs, or the log says what is not so; 2 a block is missing; 3 logs that are broken or of different "
      "campaigns.\n\n"
      "Examples:\n"
      "  delcert campaign merge part-*.jsonl --output whole.jsonl\n"
      "  delcert campaign table whole.jsonl");
  command->callback([options, &chosen] { chosen = [options] { return run_merge(*options); }; });
}

}  // namespace delcert
