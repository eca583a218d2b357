#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "properties/attack/campaign_plan.hpp"
#include "properties/attack/job_log.hpp"
#include "properties/attack/tally.hpp"

namespace delcert {

/// What the log of a campaign says of one finished block.
struct BlockRecord {
  Tally tally;
  /// For each conclusion that is violated the instance of its first violation, as text of JSON.
  std::map<std::string, std::string> violations;
  std::string host;      ///< where it was done
  std::string finished;  ///< when, as `utc_text` writes it
  double seconds = 0;    ///< how long it took
  std::size_t line = 0;  ///< of the log, from 1
};

/// Throws InputError, saying what does not fit, unless the record can be that of a block: as many samples as it has,
/// counts that add up, samples of the worst ratio and of the first violation within it, and an instance for each
/// conclusion that is violated. Precondition: is_block.
void require_record_of(const CampaignPlan& plan, const Block& block, const BlockRecord& record);

[[nodiscard]] nlohmann::ordered_json record_json(const Block& block, const BlockRecord& record);

/// All that a log of a campaign says.
struct CampaignRecord {
  std::filesystem::path path;
  CampaignPlan plan;  ///< with as many samples as the log was extended to last
  std::map<Block, BlockRecord> finished;
  std::vector<LogWriter> writers;
  bool is_torn = false;  ///< its last line was cut off, and is not counted
  std::string sum;       ///< of its last whole line
};

/// Reads a log without writing to it. Throws InputError, beginning with "FILE:LINE: ", for a line that is broken or
/// does not fit the lines before it, for a block that does not belong to the campaign or to the log's part, for a block
/// that occurs twice, and for a line that is not a record.
[[nodiscard]] CampaignRecord read_campaign(const std::filesystem::path& path);

/// The log of a campaign, to go on from and to write to: a first line that says what is attacked, a line for each
/// finished block, and one wherever the number of samples was raised.
class CampaignLog {
 public:
  /// Opens or begins the log of the plan; where it is there, its sizes of blocks hold. A log with fewer samples of some
  /// targets than the plan is extended: blocks that were cut short are done again. Throws InputError as `read_campaign`
  /// does, for a log of another campaign or part, for one with more samples than the plan, and as JobLog does.
  explicit CampaignLog(const CampaignPlan& plan);

  /// The plan, with the log's sizes of blocks.
  [[nodiscard]] const CampaignPlan& plan() const { return plan_; }
  [[nodiscard]] const std::map<Block, BlockRecord>& finished() const { return contents_.finished; }
  /// See JobLog.
  void begin() { log_->begin(); }
  /// Throws std::runtime_error if it cannot be written. Host and time of the record are filled in.
  void append(const Block& block, BlockRecord record);

 private:
  CampaignPlan plan_;
  CampaignRecord contents_;
  std::unique_ptr<JobLog> log_;
};

}  // namespace delcert
