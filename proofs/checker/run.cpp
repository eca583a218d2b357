#include "proofs/checker/run.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace delcert::checker {
namespace {

using Levels = std::array<bool, level_names.size()>;

void select(Levels& chosen, std::size_t level) {
  if (chosen[level]) return;
  chosen[level] = true;
  for (const Level base : rests_on(level)) select(chosen, base);
}

Levels selection(const Certificate& certificate, const std::vector<std::string>& selected) {
  if (selected.empty()) return certificate.claimed;
  Levels chosen{};
  for (const std::string& name : selected) {
    const auto level =
        static_cast<std::size_t>(std::find(level_names.begin(), level_names.end(), name) - level_names.begin());
    if (level == level_names.size() || !certificate.claimed[level])
      throw std::invalid_argument("level " + name + " is not claimed");
    select(chosen, level);
  }
  return chosen;
}

LevelResult run_level(const Certificate& certificate, std::size_t level) {
  using Check = std::string (*)(const Certificate&, Report&);
  const Check follows = [](const Certificate&, Report&) -> std::string { return "follows from levels 1 and 2"; };
  const std::array<Check, level_names.size()> checks = {check_level_0, check_level_1, check_level_2, check_level_2s,
                                                        check_level_3, follows,       follows,       follows};
  const auto begin = std::chrono::steady_clock::now();
  LevelResult result;
  result.level = level_names[level];
  Report report;
  try {
    result.summary = checks[level](certificate, report);
  } catch (const Undecided& reason) {
    result.status = 2;
    result.summary = reason.what();
  }
  if (!report.findings.empty()) result.status = 1;
  result.findings = report.findings;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace

Outcome check(std::string_view text, const std::vector<std::string>& selected) {
  Outcome outcome;
  decisions = {};
  try {
    const Certificate certificate(text);
    const Levels chosen = selection(certificate, selected);
    for (std::size_t level = 0; level < level_names.size(); ++level) {
      if (chosen[level]) {
        outcome.levels.push_back(run_level(certificate, level));
      } else if (certificate.claimed[level]) {
        outcome.unchecked.emplace_back(level_names[level]);
      }
    }
  } catch (const Malformed& reason) {
    outcome.status = 3;
    outcome.malformed = Finding{reason.rule, reason.what()};
  }
  for (const LevelResult& result : outcome.levels) {
    if (result.status != 0 && outcome.status != 1) outcome.status = result.status;
  }
  outcome.decisions = decisions;
  return outcome;
}

}  // namespace delcert::checker
