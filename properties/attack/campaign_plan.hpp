#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "proofs/formula/claim.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {

/// One claim in one shape, attacked with a number of samples.
struct Target {
  Claim claim;
  Shape shape;
  std::uint64_t samples = 0;
  std::uint64_t block = 0;  ///< the samples of a block; 0: as many as `block_size` says
};

/// One of several parts into which the blocks of a campaign are dealt out. Precondition: 1 ≤ number ≤ of.
struct Part {
  std::uint64_t number = 1;
  std::uint64_t of = 1;
  friend bool operator==(const Part&, const Part&) = default;
};

/// "3/8".
[[nodiscard]] std::string text_of(const Part& part);

/// The samples of one target that are done in one go, by one thread: those from `first` on.
struct Block {
  std::size_t target = 0;
  std::uint64_t first = 0;
  friend auto operator<=>(const Block&, const Block&) = default;
};

struct CampaignPlan {
  std::vector<Target> targets;
  std::uint64_t seed = 0;
  Part part;
  std::string software;  ///< what draws and decides: results of different programs are not put together
  unsigned threads = 1;
  std::uint64_t block = 250;  ///< about how many samples of an instance of cost 1 lie between two entries of the log
  /// JSON lines, one for each finished block; what it has already is not done again. Nothing is kept if empty.
  std::filesystem::path log;
};

/// The samples of a block of the target: fewer where an instance is costly, more where the log would have more than
/// 20 000 entries for the target.
[[nodiscard]] std::uint64_t block_size(const CampaignPlan& plan, const Target& target);
/// How many blocks the target has, of all parts; the last one may be shorter.
[[nodiscard]] std::uint64_t block_count(const CampaignPlan& plan, const Target& target);

/// Whether it is a block of the campaign, in whatever part.
[[nodiscard]] bool is_block(const CampaignPlan& plan, const Block& block);
/// The samples of a block. Precondition: is_block.
[[nodiscard]] std::uint64_t count_of(const CampaignPlan& plan, const Block& block);
/// The part of `of` that has the block: blocks of a target go round, and begin elsewhere for each target. It does not
/// depend on the number of samples. Precondition: is_block, of > 0.
[[nodiscard]] std::uint64_t part_of(const CampaignPlan& plan, const Block& block, std::uint64_t of);
/// The blocks of the plan's part, in order.
[[nodiscard]] std::vector<Block> blocks_of(const CampaignPlan& plan);
/// The blocks of the whole campaign are numbered from 0, target by target. Precondition: is_block.
[[nodiscard]] std::uint64_t number_of(const CampaignPlan& plan, const Block& block);
/// "block 17 (circumradius-by-thickness, k=2, m=3, samples 250 to 499)". Precondition: is_block.
[[nodiscard]] std::string name_of(const CampaignPlan& plan, const Block& block);
/// "circumradius-by-thickness (k=2, m=3)".
[[nodiscard]] std::string name_of(const Target& target);

/// The SHA-256 of all on which results depend but for the number of samples: software, seed, texts of the claims,
/// shapes, sizes of blocks. Campaigns of the same digest draw the same sample from the same number.
[[nodiscard]] std::string digest_of(const CampaignPlan& plan);

/// The first line of the log of a plan, and back: the plan that a first line describes, without log and threads. Throws
/// InputError or nlohmann::json::exception if the line does not describe a plan or its digest does not fit.
[[nodiscard]] nlohmann::ordered_json header_of(const CampaignPlan& plan);
[[nodiscard]] CampaignPlan plan_from(const nlohmann::ordered_json& header);

/// Throws InputError, saying what differs first, unless the digests agree.
void require_same_campaign(const CampaignPlan& plan, const CampaignPlan& other);

}  // namespace delcert
