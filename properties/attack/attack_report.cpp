#include "properties/attack/attack_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "proofs/publication/latex_table.hpp"
#include "support/latex_text.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

std::string share(std::uint64_t part, std::uint64_t whole) {
  if (part == 0 || whole == 0) return "0";
  const double percent = 100 * static_cast<double>(part) / static_cast<double>(whole);
  if (percent < 0.1) return "<0.1 %";
  return fmt::format("{:.1f} %", percent);
}

std::string instances_text(std::uint64_t count) { return fmt::format("{} instance{}", count, count == 1 ? "" : "s"); }

std::string verdict_of_attack(const ConclusionTally& conclusion, std::uint64_t least_instances) {
  if (conclusion.violated > 0) return fmt::format("REFUTED ({})", conclusion.violated);
  if (conclusion.undecided > 0) return "undecided";
  if (conclusion.held == 0) return "not attacked";
  if (conclusion.held < least_instances) return "hardly attacked: " + instances_text(conclusion.held);
  return "not refuted by " + instances_text(conclusion.held);
}

std::string rungs_text(const LadderStatistics& rungs) {
  std::string result;
  for (const std::uint64_t settled : rungs.settled) {
    result += (result.empty() ? "" : " / ") + share(settled, rungs.total());
  }
  return result;
}

/// Where the instances live; with shares if there are several manifolds.
std::string manifolds_text(const Tally& tally) {
  std::string result;
  for (const auto& [name, count] : tally.manifolds) {
    result += (result.empty() ? "" : " / ") + name;
    if (tally.manifolds.size() > 1) result += " " + share(count, tally.met());
  }
  return result.empty() ? "–" : result;
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

/// A conclusion of a claim in one shape, or in all of the same k.
struct AttackRow {
  std::string name;  ///< claim / conclusion
  std::string shape;
  Tally tally;
  std::size_t number;  ///< of the conclusion
  [[nodiscard]] const ConclusionTally& conclusion() const { return tally.conclusions[number]; }
};

std::vector<AttackRow> attack_rows(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                                   bool is_short) {
  std::vector<AttackRow> result;
  for (std::size_t first = 0, last = 0; first < targets.size(); first = last + 1) {
    last = is_short ? last_of_same_k(targets, first) : first;
    Tally tally = tallies[first];
    for (std::size_t at = first + 1; at <= last; ++at) tally.add(tallies[at]);
    const std::string shape =
        text_of(targets[first].shape) + (first < last ? fmt::format("…{}", targets[last].shape.m) : std::string());
    for (std::size_t one = 0; one < tally.conclusions.size(); ++one) {
      const Claim& claim = targets[first].claim;
      result.push_back({claim.name + " / " + claim.conclusions[one].name, shape, tally, one});
    }
  }
  return result;
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

std::string attack_table(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                         std::uint64_t least_instances, bool is_short) {
  std::string result =
      "| claim / conclusion | shape | manifolds | samples | discarded | boundary | thin | cospherical | worst ratio | "
      "interval / big / rational / algebraic | undecided | verdict |\n"
      "|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|---|\n";
  for (const AttackRow& row : attack_rows(targets, tallies, is_short)) {
    const Tally& tally = row.tally;
    const ConclusionTally& conclusion = row.conclusion();
    result +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.name, row.shape,
                    manifolds_text(tally), tally.samples, share(tally.samples - tally.met(), tally.samples),
                    share(tally.traits[0], tally.met()), share(tally.traits[1], tally.met()),
                    share(tally.traits[2], tally.met()), ratio_text(conclusion.worst), rungs_text(tally.rungs),
                    conclusion.undecided + tally.hypotheses_undecided, verdict_of_attack(conclusion, least_instances));
  }
  return result;
}

std::string attack_latex(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                         std::uint64_t least_instances, bool is_short) {
  std::vector<std::vector<std::string>> rows;
  for (const AttackRow& row : attack_rows(targets, tallies, is_short)) {
    const ConclusionTally& conclusion = row.conclusion();
    rows.push_back({latex_label(row.name), latex_text(row.shape), std::to_string(row.tally.samples),
                    latex_text(share(row.tally.samples - row.tally.met(), row.tally.samples)),
                    latex_text(ratio_text(conclusion.worst)),
                    latex_text(verdict_of_attack(conclusion, least_instances))});
  }
  return latex_table({{"claim / conclusion", 90},
                      {"shape", 40},
                      {"samples", 42},
                      {"discarded", 36},
                      {"worst ratio", 60},
                      {"verdict", 47}},
                     rows);
}

Json attack_json(const std::vector<Target>& targets, const std::vector<Tally>& tallies, std::uint64_t least_instances) {
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
      entry["verdict"] = verdict_of_attack(tallies[at].conclusions[conclusion], least_instances);
    }
    result.push_back(std::move(one));
  }
  return result;
}

std::vector<AttackTotal> attack_totals(const std::vector<Target>& targets, const std::vector<Tally>& tallies) {
  std::vector<AttackTotal> result;
  for (std::size_t at = 0; at < targets.size(); ++at) {
    const Claim& claim = targets[at].claim;
    for (std::size_t one = 0; one < claim.conclusions.size(); ++one) {
      const std::string& name = claim.conclusions[one].name;
      auto total = std::find_if(result.begin(), result.end(), [&](const AttackTotal& other) {
        return other.claim == claim.name && other.conclusion == name;
      });
      if (total == result.end()) total = result.insert(total, AttackTotal{claim.name, name, 0, {}, {}});
      const ConclusionTally& conclusion = tallies[at].conclusions[one];
      if (tallies[at].met() > 0) ++total->shapes;
      total->tally.held += conclusion.held;
      total->tally.violated += conclusion.violated;
      total->tally.undecided += conclusion.undecided;
      for (std::size_t trait = 0; trait < total->traits.size(); ++trait) {
        total->traits[trait] += tallies[at].traits[trait];
      }
    }
  }
  return result;
}

std::uint64_t noticeable_share(std::uint64_t instances) {
  // All N instances hold with the probability (1 − p)^N if a share p violates, which is at most 1/20 from
  // p = 1 − 20^(−1/N) on.
  if (instances < 5) return 0;
  const double share = -std::expm1(-std::log(20.0) / static_cast<double>(instances));
  return static_cast<std::uint64_t>(1 / share * (1 - 0x1p-40));
}

std::string totals_text(const std::vector<AttackTotal>& totals, std::uint64_t least_instances) {
  std::string result;
  for (const AttackTotal& total : totals) {
    if (total.tally.violated > 0 || total.tally.held == 0) continue;
    result += fmt::format("{} / {}: {} in {} shape{}, of them boundary {}, thin {}, cospherical {}", total.claim,
                          total.conclusion, verdict_of_attack(total.tally, least_instances), total.shapes,
                          total.shapes == 1 ? "" : "s", total.traits[0], total.traits[1], total.traits[2]);
    const std::uint64_t one_in = noticeable_share(total.tally.held);
    if (one_in > 0 && total.tally.undecided == 0) {
      result += fmt::format("; violations by 1 in {} such instances would have shown, with probability 95 %", one_in);
    }
    result += "\n";
  }
  return result;
}

Json totals_json(const std::vector<AttackTotal>& totals, std::uint64_t least_instances) {
  Json result = Json::array();
  for (const AttackTotal& total : totals) {
    result.push_back({{"claim", total.claim},
                      {"conclusion", total.conclusion},
                      {"verdict", verdict_of_attack(total.tally, least_instances)},
                      {"shapes", total.shapes},
                      {"held", total.tally.held},
                      {"violated", total.tally.violated},
                      {"undecided", total.tally.undecided},
                      {"boundary", total.traits[0]},
                      {"thin", total.traits[1]},
                      {"cospherical", total.traits[2]},
                      {"noticeable_share_one_in", noticeable_share(total.tally.held)}});
  }
  return result;
}

}  // namespace delcert
