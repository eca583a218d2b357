#include "apps/attack_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/claim_options.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

std::string share(std::uint64_t part, std::uint64_t whole) {
  if (part == 0 || whole == 0) return "0";
  const double percent = 100 * static_cast<double>(part) / static_cast<double>(whole);
  if (percent < 0.1) return "<0.1 %";
  return fmt::format("{:.1f} %", percent);
}

std::string verdict_text(const ConclusionTally& conclusion) {
  if (conclusion.violated > 0) return fmt::format("REFUTED ({})", conclusion.violated);
  if (conclusion.undecided > 0) return "undecided";
  return conclusion.held > 0 ? "held" : "not attacked";
}

std::string rungs_text(const LadderStatistics& rungs) {
  std::string result;
  for (const std::uint64_t settled : rungs.settled) {
    result += (result.empty() ? "" : " / ") + share(settled, rungs.total());
  }
  return result;
}

/// The last of the targets from `first` on that are of the same claim and the same k > 0.
std::size_t last_of_same_k(const std::vector<Target>& targets, std::size_t first) {
  std::size_t last = first;
  const auto is_same = [&](const Target& target) {
    return target.claim.name == targets[first].claim.name && target.shape.k > 0 &&
           target.shape.k == targets[first].shape.k;
  };
  while (last + 1 < targets.size() && is_same(targets[last + 1])) ++last;
  return last;
}

}  // namespace

std::string ratio_text(const std::optional<DoubleBounds>& ratio) {
  if (!ratio) return "–";
  if (!std::isfinite(ratio->lower) || !std::isfinite(ratio->upper)) return "unbounded";
  for (int digits = 9; digits >= 2; --digits) {
    std::string lower = fmt::format("{:.{}g}", ratio->lower, digits);
    if (lower == fmt::format("{:.{}g}", ratio->upper, digits)) return lower;
  }
  return fmt::format("[{:.3g}, {:.3g}]", ratio->lower, ratio->upper);
}

std::string attack_table(const std::vector<Target>& targets, const std::vector<Tally>& tallies, bool is_short) {
  std::string result =
      "| claim / conclusion | shape | samples | discarded | boundary | thin | cospherical | worst ratio | "
      "interval / big / rational / algebraic | undecided | verdict |\n"
      "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|---|\n";
  for (std::size_t first = 0, last = 0; first < targets.size(); first = last + 1) {
    last = is_short ? last_of_same_k(targets, first) : first;
    Tally tally = tallies[first];
    for (std::size_t at = first + 1; at <= last; ++at) tally.add(tallies[at]);
    const std::string shape =
        text_of(targets[first].shape) + (first < last ? fmt::format("…{}", targets[last].shape.m) : std::string());
    for (std::size_t one = 0; one < tally.conclusions.size(); ++one) {
      const ConclusionTally& conclusion = tally.conclusions[one];
      result += fmt::format("| {} / {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                            targets[first].claim.name, targets[first].claim.conclusions[one].name, shape, tally.samples,
                            share(tally.samples - tally.met(), tally.samples), share(tally.traits[0], tally.met()),
                            share(tally.traits[1], tally.met()), share(tally.traits[2], tally.met()),
                            ratio_text(conclusion.worst), rungs_text(tally.rungs),
                            conclusion.undecided + tally.hypotheses_undecided, verdict_text(conclusion));
    }
  }
  return result;
}

Json attack_json(const std::vector<Target>& targets, const std::vector<Tally>& tallies) {
  Json result = Json::array();
  for (std::size_t at = 0; at < targets.size(); ++at) {
    Json one;
    one["claim"] = targets[at].claim.name;
    one["source"] = targets[at].claim.source;
    one["status"] = name_of(targets[at].claim.status);
    one["k"] = targets[at].shape.k;
    one["m"] = targets[at].shape.m;
    one["tally"] = tally_json(tallies[at]);
    for (std::size_t conclusion = 0; conclusion < targets[at].claim.conclusions.size(); ++conclusion) {
      Json& entry = one["tally"]["conclusions"][conclusion];
      entry["name"] = targets[at].claim.conclusions[conclusion].name;
      entry["verdict"] = verdict_text(tallies[at].conclusions[conclusion]);
    }
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace delcert
