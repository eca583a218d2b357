#include "proofs/tables/powers.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "kernel/number/decimal_bounds.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/tables/worst_ratios.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// At least 1, and the greater the farther from it.
Rational distance_from_one(const Rational& scale) { return scale < Rational(1) ? Rational(1) / scale : scale; }

constexpr const char* power_command =
    "{ delcert power circumradius-under-distortion circumradius-under-distortion-sharper \\\n"
    "    circumscribing-balls-under-distortion circumscribing-balls-under-distortion-sharper \\\n"
    "    thickness-under-distortion crude-circumradius-bound \\\n"
    "    --shape 1,1 --shape 2,2 --shape 3,3 --seed 1 --evaluations 1000 --json\n"
    "  delcert power raw-hoop-distortion raw-hoop-distortion-sharper hoop-distortion hoop-distortion-sharper \\\n"
    "    --shape 2,2 --shape 3,3 --seed 1 --evaluations 100 --json\n"
    "  delcert power stable-stars delaunay-metric-stability --shape 2 --seed 1 --evaluations 2000 --json\n"
    "  delcert power curved-stable-stars curved-delaunay-complex --shape 2 --seed 1 --evaluations 2000 --json\n"
    "} | jq --slurp add > docs/tables/power.json\n";

std::string in_cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c == '\n' ? ' ' : c);
  return result;
}

bool is_same_place(const PowerOfPlace& a, const PowerOfPlace& b) {
  return a.claim == b.claim && a.part == b.part && a.place == b.place && a.kind == b.kind;
}

std::string deletion_by_dimension(const std::vector<PowerOfPlace>& powers, const PowerOfPlace& place) {
  std::map<std::string, std::string> known;
  for (const PowerOfPlace& power : powers) {
    if (!is_same_place(power, place) || !power.can_be_deleted) continue;
    std::string& text = known[power.dimension];
    if (power.is_deletion_refuted) text = "refuted";
    if (text.empty() || (text == "says less" && !power.says_less)) text = power.says_less ? "says less" : "no power";
  }
  std::string result;
  for (const auto& [dimension, text] : known) result += (result.empty() ? "" : ", ") + dimension + ": " + text;
  return result.empty() ? "–" : result;
}

/// With how many instances each dimension of a place was searched: one number if it is the same for all.
std::string evaluations_by_dimension(const std::vector<PowerOfPlace>& powers, const PowerOfPlace& place) {
  std::map<std::string, std::uint64_t> most;
  std::set<std::uint64_t> numbers;
  for (const PowerOfPlace& power : powers) {
    if (is_same_place(power, place)) {
      std::uint64_t& known = most[power.dimension];
      known = std::max(known, power.evaluations);
    }
  }
  std::string result;
  for (const auto& [dimension, number] : most) {
    numbers.insert(number);
    result += (result.empty() ? "" : ", ") + dimension + ": " + std::to_string(number);
  }
  return numbers.size() == 1 ? std::to_string(*numbers.begin()) : result;
}

}  // namespace

std::vector<PowerOfPlace> parse_powers(const std::string& json, const std::string& file) {
  std::vector<PowerOfPlace> result;
  try {
    const auto list = nlohmann::json::parse(json);
    if (!list.is_array()) throw InputError(file + ": not what delcert power --json prints: no list");
    for (const auto& one : list) {
      PowerOfPlace power;
      power.claim = one.at("claim").get<std::string>();
      power.part = one.at(one.contains("hypothesis") ? "hypothesis" : "conclusion").get<std::string>();
      power.dimension = dimension_name(one.at("k").get<int>(), one.at("m").get<int>());
      power.place = one.at("place").get<std::string>();
      power.kind = one.at("kind").get<std::string>();
      if (one.contains("scale")) power.scale = parse_exact(one.at("scale").get<std::string>());
      if (power.scale && *power.scale <= Rational(0)) throw InputError(file + ": a scale is not above 0");
      power.is_deletion_refuted = one.value("deletion_refuted", false);
      power.can_be_deleted = one.contains("deletion_refuted");
      power.says_less = one.value("says_less", false);
      power.evaluations = one.value("evaluations", std::uint64_t{0});
      if (one.value("instance", true)) result.push_back(std::move(power));
    }
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file + ": not what delcert power --json prints: " + error.what());
  } catch (const ExactTextError& error) {
    throw InputError(file + ": not what delcert power --json prints: " + error.what());
  }
  return result;
}

std::string power_by_dimension(const std::vector<PowerOfPlace>& powers, const std::string& claim,
                               const std::string& part, const std::string& place, const std::string& kind) {
  std::map<std::string, std::optional<Rational>> least;
  for (const PowerOfPlace& power : powers) {
    if (power.claim != claim || power.part != part || power.place != place || power.kind != kind) continue;
    auto& known = least[power.dimension];
    if (power.scale && (!known || distance_from_one(*power.scale) < distance_from_one(*known))) known = power.scale;
  }
  std::string result;
  for (const auto& [dimension, scale] : least) {
    result += (result.empty() ? "" : ", ") + dimension + ": " + (scale ? scale_text(*scale) : "no power");
  }
  return result;
}

std::string power_page(const std::vector<PowerOfPlace>& powers) {
  std::string text = R"(# What an attack would have noticed

For each term of each bound, the scale nearest to 1 with which a directed search refuted the claim, for each dimension, the best of
its shapes, and whether it refuted the claim without the term ([attacks.md](../attacks.md#by-how-much-would-a-constant-have-to-be-wrong)
says how). *no power*: nothing that was tried noticed the change, which says nothing about whether the claim with it is true. *says
less*: without this factor the conclusion is weaker. A hypothesis is widened. *Instances*: so many were tried for each place, which are fewer
than the commands ask for where an instance is costly. The commands, whose `--witnesses` are exact instances:

```
)";
  text += power_command;
  text += R"(```

This page is what `delcert tables --power docs/tables/power.json --places` prints; a test compares them.

| claim / part | place | kind | refuted when scaled | when deleted | instances |
|---|---|---|---|---|--:|
)";
  std::vector<std::array<std::string, 4>> known;
  for (const PowerOfPlace& power : powers) {
    const std::array<std::string, 4> key = {power.claim, power.part, power.place, power.kind};
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    known.push_back(key);
    const std::string scaled =
        power.kind == "factor" ? "–" : power_by_dimension(powers, power.claim, power.part, power.place, power.kind);
    text += "| " + power.claim + " / " + power.part + " | `" + in_cell(power.place) + "` | " + power.kind + " | " +
            scaled + " | " + deletion_by_dimension(powers, power) + " | " + evaluations_by_dimension(powers, power) +
            " |\n";
  }
  return text;
}

std::string scale_text(const Rational& scale) {
  constexpr int digits = 3;
  if (scale == Rational(1)) return "refuted";
  return "× " + (scale < Rational(1) ? decimal_lower(scale, digits) : decimal_upper(scale, digits));
}

}  // namespace delcert
