#include "proofs/certificate/stated_levels.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string_view>

#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/summary_json.hpp"

namespace delcert {

namespace {

struct KindOfBound {
  std::string_view level;
  std::string_view key;
  Margin::Side side;
  Margin::Unit unit;
};

constexpr auto at_least_here = Margin::Side::lower;
constexpr auto at_most_here = Margin::Side::upper;

/// `bilipschitz`, which is two bounds or none, is not among them.
constexpr std::array<KindOfBound, 20> kinds_of_bounds{{{"0", "density", at_most_here, Margin::Unit::length},
                                                       {"0", "distortion", at_most_here, Margin::Unit::one},
                                                       {"0", "metric_distortion", at_most_here, Margin::Unit::one},
                                                       {"1", "protection", at_least_here, Margin::Unit::length},
                                                       {"1", "thickness", at_least_here, Margin::Unit::one},
                                                       {"1", "circumradius", at_most_here, Margin::Unit::length},
                                                       {"2s", "reach", at_most_here, Margin::Unit::length},
                                                       {"4", "protection", at_least_here, Margin::Unit::length},
                                                       {"4", "circumradius", at_most_here, Margin::Unit::length},
                                                       {"4", "edge", at_least_here, Margin::Unit::length},
                                                       {"4", "margin", at_least_here, Margin::Unit::squared_length},
                                                       {"4", "density", at_most_here, Margin::Unit::length},
                                                       {"5", "thickness", at_least_here, Margin::Unit::one},
                                                       {"5", "radius", at_most_here, Margin::Unit::length},
                                                       {"5", "contraction", at_most_here, Margin::Unit::one},
                                                       {"5", "displacement", at_most_here, Margin::Unit::length},
                                                       {"5i", "margin", at_least_here, Margin::Unit::length},
                                                       {"5i", "cosine", at_least_here, Margin::Unit::one},
                                                       {"6", "weight", at_least_here, Margin::Unit::one},
                                                       {"6", "normal", at_most_here, Margin::Unit::one}}};

std::vector<std::string> parts_of_list(std::string_view text) {
  std::vector<std::string> result;
  for (std::size_t comma = 0; (comma = text.find(", ")) != std::string_view::npos; text.remove_prefix(comma + 2))
    result.emplace_back(text.substr(0, comma));
  result.emplace_back(text);
  return result;
}

std::vector<Margin> stated_margins(std::string_view level, std::string_view key, const std::string& text) {
  if (level == "6" && key == "bilipschitz") {
    const std::vector<std::string> both = parts_of_list(text);
    return {{parse_exact(both.front()), Margin::Side::lower, Margin::Unit::one},
            {parse_exact(both.back()), Margin::Side::upper, Margin::Unit::one}};
  }
  const auto kind = std::find_if(kinds_of_bounds.begin(), kinds_of_bounds.end(),
                                 [&](const KindOfBound& each) { return each.level == level && each.key == key; });
  if (kind == kinds_of_bounds.end()) return {};
  return {{parse_exact(text), kind->side, kind->unit}};
}

/// Of what is no bound, by its key: truths, numbers of things, the list of groups; all else is text.
nlohmann::ordered_json stated_fact(std::string_view key, const std::string& text) {
  const bool is_truth = key == "hypotheses_2" || key == "closed" || key == "self_delaunay";
  if (is_truth && (text == "true" || text == "false")) return text == "true";
  if (key == "homology") return parts_of_list(text);
  if (key == "simplices" || key == "euler_characteristic") {
    long number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure == std::errc() && end == text.data() + text.size()) return number;
  }
  return text;
}

}  // namespace

std::vector<ClaimedLevel> stated_levels(const CertificateSummary& certificate) {
  std::vector<ClaimedLevel> result;
  for (const auto& [level, entries] : certificate.levels) {
    result.push_back({level, {}});
    for (const auto& [key, text] : entries) {
      LevelEntry entry{key, {}, ""};
      try {
        entry.margins = stated_margins(level, key, text);
      } catch (const ExactTextError& error) {
        throw InputError("levels: \"" + level + "\": \"" + key + "\": " + error.what());
      }
      const nlohmann::ordered_json fact = entry.margins.empty() ? stated_fact(key, text) : nlohmann::ordered_json(text);
      entry.json = ascii_text(fact);
      result.back().entries.push_back(std::move(entry));
    }
  }
  return result;
}

}  // namespace delcert
