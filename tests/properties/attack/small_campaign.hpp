// A small campaign, its log, and what a forger does to it.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "properties/attack/campaign.hpp"
#include "tests/properties/attack/small_claims.hpp"
#include "tests/support/content_of.hpp"

namespace delcert::test {

/// Of 12 blocks, those of the first target refuted.
inline CampaignPlan small_campaign(const std::filesystem::path& log) {
  CampaignPlan plan;
  plan.targets = {{wrong_claim(), {2, 2}, 65}, {right_claim(), {1, 2}, 35}, {right_claim(), {2, 2}, 1}};
  plan.seed = 3;
  plan.software = "delcert 7";
  plan.block = 10;
  plan.log = log;
  return plan;
}

/// The same, one of several parts of it.
inline CampaignPlan small_part(const std::filesystem::path& log, std::uint64_t number, std::uint64_t of) {
  CampaignPlan plan = small_campaign(log);
  plan.part = {number, of};
  return plan;
}

inline std::string text_of(const std::vector<Tally>& tallies) {
  std::string result;
  for (const Tally& tally : tallies) result += tally_json(tally).dump() + "\n";
  return result;
}

using LogLines = std::vector<nlohmann::ordered_json>;

/// The lines of a log without their sums.
inline LogLines lines_of(const std::filesystem::path& path) {
  LogLines result;
  Chain chain;
  (void)read_chained_lines(path, "a log", chain,
                           [&](const nlohmann::ordered_json& line, std::size_t) { result.push_back(line); });
  return result;
}

/// A log of these lines, with all sums computed anew.
inline void write_lines(const std::filesystem::path& path, const LogLines& lines) {
  std::ofstream stream(path, std::ios::binary);
  Chain chain;
  for (const auto& line : lines) stream << chain.seal(line) << "\n";
}

/// Changes the lines of a log, and computes all sums anew: what a forger does who has read the documentation.
inline void forge(const std::filesystem::path& path, const std::function<void(LogLines&)>& change) {
  LogLines lines = lines_of(path);
  change(lines);
  write_lines(path, lines);
}

}  // namespace delcert::test
