#include "properties/attack/campaign_log.hpp"

#include <nlohmann/json.hpp>

namespace delcert {

CampaignLog::CampaignLog(const std::filesystem::path& path, const std::string& identity)
    : log_(path, "campaign", identity, [this](const nlohmann::ordered_json& line) {
        finished_[{line.at("target").get<std::size_t>(), line.at("first").get<std::uint64_t>()}] =
            tally_from(line.at("tally"));
      }) {}

void CampaignLog::append(const Block& block, const Tally& tally) {
  log_.append({{"target", block.first}, {"first", block.second}, {"tally", tally_json(tally)}});
}

}  // namespace delcert
