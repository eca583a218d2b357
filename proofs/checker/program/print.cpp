#include <cstdio>
#include <nlohmann/json.hpp>

#include "proofs/checker/run.hpp"

namespace delcert::checker {
namespace {

const char* status_name(int status) {
  constexpr std::array<const char*, 4> names = {"verified", "rejected", "undecided", "malformed"};
  return names[static_cast<std::size_t>(status)];
}

/// A level that holds in a run that fails, or in a part, is only "passed".
const char* level_state(const Outcome& outcome, const LevelResult& result) {
  if (result.status == 1) return "REJECTED";
  return result.status == 0 && !outcome.is_verified() ? "passed" : status_name(result.status);
}

const char* state(const Outcome& outcome) {
  return outcome.status == 0 && !outcome.is_verified() ? "passed" : status_name(outcome.status);
}

std::string of_share(const Share& share) { return std::to_string(share.number) + "/" + std::to_string(share.of); }

nlohmann::ordered_json as_object(const Finding& finding) { return {{"rule", finding.rule}, {"what", finding.what}}; }

nlohmann::ordered_json as_object(const Identity& identity, bool with_name) {
  const auto known = [](const std::string& text) -> nlohmann::ordered_json {
    if (text.empty()) return nullptr;
    return text;
  };
  return {{"family", identity.family},
          {"dimension", identity.dimension},
          {"size", known(identity.size)},
          {"orientability", known(identity.orientability)},
          {"first_homology", known(identity.first_homology)},
          {"name_as_stated", with_name ? nlohmann::ordered_json(identity.name) : nullptr},
          {"manifold_sha256", identity.manifold_digest},
          {"file_sha256", known(identity.file_digest)}};
}

}  // namespace

std::string LevelResult::words() const {
  std::string text = summary;
  for (const Range& range : ranges) {
    for (const auto& [name, number] : range.counts) {
      const std::string mark = "{" + name + "}";
      const std::size_t at = text.find(mark);
      if (at != std::string::npos) text.replace(at, mark.size(), std::to_string(number));
    }
  }
  return text;
}

std::string as_text(const Outcome& outcome) {
  if (outcome.malformed) return "malformed: " + outcome.malformed->rule + ": " + outcome.malformed->what + "\n";
  std::string text, checked, unchecked;
  if (outcome.identity) text = "manifold   " + to_string(*outcome.identity, outcome.is_verified()) + "\n";
  for (const LevelResult& result : outcome.levels) {
    std::array<char, 64> head{}, tail{};
    std::snprintf(head.data(), head.size(), "level %-4s %-10s ", result.level.c_str(), level_state(outcome, result));
    std::snprintf(tail.data(), tail.size(), "  [%.2f s]\n", result.seconds);
    if (result.findings.empty()) text += head.data() + result.words() + tail.data();
    for (const Finding& finding : result.findings) text += head.data() + finding.rule + ": " + finding.what + "\n";
    checked += " " + result.level;
  }
  for (const std::string& level : outcome.unchecked) unchecked += " " + level;
  const std::string part = outcome.share.is_whole() ? "" : ", part " + of_share(outcome.share);
  return text + state(outcome) + part + ": levels" + checked +
         (unchecked.empty() ? "" : "; claimed but not checked:" + unchecked) + " (" +
         std::to_string(outcome.decisions.filtered) + " decisions by intervals, " +
         std::to_string(outcome.decisions.exact) + " by rationals" +
         (outcome.decisions.enclosed == 0 ? "" : ", " + std::to_string(outcome.decisions.enclosed) + " by balls") +
         ")\n";
}

std::string as_json(const std::string& file, const Outcome& outcome) {
  nlohmann::ordered_json levels = nlohmann::ordered_json::array();
  for (const LevelResult& result : outcome.levels) {
    nlohmann::ordered_json findings = nlohmann::ordered_json::array();
    for (const Finding& finding : result.findings) findings.push_back(as_object(finding));
    levels.push_back({{"level", result.level},
                      {"state", level_state(outcome, result)},
                      {"summary", result.words()},
                      {"findings", findings},
                      {"seconds", result.seconds}});
  }
  nlohmann::ordered_json object = {{"file", file}, {"status", state(outcome)}, {"exit", outcome.status}};
  if (!outcome.share.is_whole()) object["part"] = of_share(outcome.share);
  object["malformed"] = outcome.malformed ? as_object(*outcome.malformed) : nullptr;
  object["manifold"] = outcome.identity ? as_object(*outcome.identity, outcome.is_verified()) : nullptr;
  object["levels"] = levels;
  object["unchecked"] = outcome.unchecked;
  object["decisions"] = {{"intervals", outcome.decisions.filtered},
                         {"rationals", outcome.decisions.exact},
                         {"balls", outcome.decisions.enclosed}};
  return object.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace delcert::checker
