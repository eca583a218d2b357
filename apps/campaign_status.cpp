#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/campaign_commands.hpp"
#include "apps/interruption.hpp"
#include "properties/attack/campaign_merge.hpp"
#include "support/duration.hpp"
#include "support/text_table.hpp"
#include "support/utc_time.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

struct StatusOptions {
  std::vector<std::string> logs;
  bool json = false;
};

/// How far a log has come.
struct LogStatus {
  std::string file;
  Part part;
  std::uint64_t blocks = 0;
  std::uint64_t finished_blocks = 0;
  std::uint64_t samples = 0;
  std::uint64_t finished_samples = 0;
  std::uint64_t violated = 0;                  ///< blocks that refute a conclusion
  std::map<std::string, std::uint64_t> hosts;  ///< how many blocks each has done
  std::string last;                            ///< when the last block was finished; may be empty
  std::optional<LogWriter> writer;             ///< the last one
  bool is_running = false;
  bool is_torn = false;
  std::optional<double> rate;  ///< samples a second, of the last writer

  [[nodiscard]] std::string state() const {
    if (finished_blocks == blocks) return "finished";
    return is_running ? "running" : "stopped";
  }
  /// At the rate of before, in seconds; nothing for what does not run.
  [[nodiscard]] std::optional<std::int64_t> left() const {
    if (!is_running || !rate || *rate <= 0) return std::nullopt;
    return static_cast<std::int64_t>(static_cast<double>(samples - finished_samples) / *rate);
  }
};

/// Over the time from when the last process began until its last block.
std::optional<double> rate_of(const CampaignRecord& log) {
  if (log.writers.empty()) return std::nullopt;
  const auto begun = parse_utc(log.writers.back().begun);
  std::uint64_t samples = 0;
  auto last = begun;
  for (const auto& [block, record] : log.finished) {
    const auto finished = parse_utc(record.finished);
    if (finished < begun || record.host != log.writers.back().host) continue;
    samples += record.tally.samples;
    last = std::max(last, finished);
  }
  if (last == begun) return std::nullopt;
  return static_cast<double>(samples) / static_cast<double>((last - begun).count());
}

LogStatus status_of(const std::string& path) {
  LogStatus result;
  result.file = path;
  // Asked first: what is finished afterwards is then still in the log.
  result.is_running = is_being_written(path);
  const CampaignRecord log = read_campaign(path);
  result.part = log.plan.part;
  for (const Block& block : blocks_of(log.plan)) {
    ++result.blocks;
    result.samples += count_of(log.plan, block);
  }
  result.finished_blocks = log.finished.size();
  for (const auto& [block, record] : log.finished) {
    result.finished_samples += record.tally.samples;
    if (record.tally.is_refuted()) ++result.violated;
    ++result.hosts[record.host];
    result.last = std::max(result.last, record.finished);
  }
  if (!log.writers.empty()) result.writer = log.writers.back();
  result.is_torn = log.is_torn;
  result.rate = rate_of(log);
  return result;
}

std::string hosts_text(const LogStatus& status) {
  std::string result;
  for (const auto& [host, blocks] : status.hosts) result += (result.empty() ? "" : ", ") + host;
  return result;
}

std::string share_text(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? "" : fmt::format("{} %", part * 100 / whole);
}

void print_text(const std::vector<LogStatus>& all) {
  std::vector<std::vector<std::string>> rows{
      {"log", "part", "state", "blocks", "share", "samples/s", "left", "refuting", "last block", "hosts"}};
  std::uint64_t blocks = 0;
  std::uint64_t finished = 0;
  std::int64_t left = 0;
  for (const LogStatus& one : all) {
    blocks += one.blocks;
    finished += one.finished_blocks;
    const auto its = one.left();
    left = std::max(left, its.value_or(0));
    rows.push_back({one.file, text_of(one.part), one.state() + (one.is_torn ? ", last line torn" : ""),
                    fmt::format("{}/{}", one.finished_blocks, one.blocks),
                    share_text(one.finished_samples, one.samples), one.rate ? fmt::format("{:.1f}", *one.rate) : "",
                    its ? duration_text(std::chrono::seconds(*its)) : "", std::to_string(one.violated), one.last,
                    hosts_text(one)});
  }
  std::cout << text_table(rows);
  const auto count = [&](const char* state) {
    return std::count_if(all.begin(), all.end(), [&](const LogStatus& one) { return one.state() == state; });
  };
  std::cout << fmt::format("{} of {} blocks; {} of {} logs finished, {} running, {} stopped", finished, blocks,
                           count("finished"), all.size(), count("running"), count("stopped"));
  if (left > 0) std::cout << ", about " << duration_text(std::chrono::seconds(left)) << " left";
  std::cout << "\n";
}

Json json_of(const LogStatus& status) {
  Json result{{"file", status.file},
              {"part", {status.part.number, status.part.of}},
              {"state", status.state()},
              {"blocks", status.blocks},
              {"finished_blocks", status.finished_blocks},
              {"samples", status.samples},
              {"finished_samples", status.finished_samples},
              {"refuting_blocks", status.violated},
              {"hosts", status.hosts},
              {"torn", status.is_torn}};
  if (status.rate) result["samples_a_second"] = *status.rate;
  if (const auto left = status.left()) result["seconds_left"] = *left;
  if (!status.last.empty()) result["last_block"] = status.last;
  if (status.writer) {
    result["writer"] = {
        {"host", status.writer->host}, {"process", status.writer->process}, {"begun", status.writer->begun}};
  }
  return result;
}

ExitStatus run_status(const StatusOptions& options) {
  std::vector<LogStatus> all;
  for (const std::string& path : options.logs) {
    throw_if_interrupted();
    all.push_back(status_of(path));
  }
  if (!options.json) {
    print_text(all);
    return ExitStatus::verified;
  }
  Json logs = Json::array();
  for (const LogStatus& one : all) logs.push_back(json_of(one));
  std::cout << Json{{"logs", logs}}.dump(1) << "\n";
  return ExitStatus::verified;
}

}  // namespace

void add_campaign_status(CLI::App& campaign, Action& chosen) {
  const auto options = std::make_shared<StatusOptions>();
  CLI::App* command = campaign.add_subcommand("status", "Say how far logs have come, who writes to them, what is left");
  command->add_option("logs", options->logs, "Logs of delcert attack")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Reads only, also while others write. Exit status 0 for every log that can be read, finished or not.\n\n"
      "Example:\n"
      "  delcert campaign status part-*.jsonl");
  command->callback([options, &chosen] { chosen = [options] { return run_status(*options); }; });
}

}  // namespace delcert
