#include "proofs/checker/run.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "proofs/checker/levels.hpp"

namespace delcert::checker {
namespace {

using State = LevelResult::State;

std::string check_level(const Certificate& certificate, std::size_t level, Report& report) {
  switch (level) {
    case level_0:
      return check_level_0(certificate, report);
    case level_1:
      return check_level_1(certificate, report);
    case level_2:
      return check_level_2(certificate, report);
    case level_2s:
      return check_level_2s(certificate, report);
    case level_3:
      return check_level_3(certificate, report);
    case level_4:
      return "follows from levels 1 and 2";
    default:
      return "follows from level " + std::string(level_names[level - 1]);
  }
}

void select(std::array<bool, level_names.size()>& chosen, Level level) {
  if (chosen[level]) return;
  chosen[level] = true;
  for (const Level base : rests_on(level)) select(chosen, base);
}

LevelResult run_level(const Certificate& certificate, std::size_t level) {
  const auto begin = std::chrono::steady_clock::now();
  Report report;
  LevelResult result;
  result.level = level_names[level];
  try {
    result.summary = check_level(certificate, level, report);
  } catch (const Undecided& reason) {
    result.state = State::undecided;
    result.findings.push_back({"", reason.what()});
  }
  if (!report.findings.empty()) {
    result.state = State::rejected;
    result.findings = report.findings;
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

/// A level that passes is unsupported if one on which it rests does not.
void withdraw_unsupported(std::vector<LevelResult>& levels) {
  const auto find = [&](std::string_view name) {
    return std::find_if(levels.begin(), levels.end(), [&](const LevelResult& r) { return r.level == name; });
  };
  for (std::size_t round = 0; round < level_names.size(); ++round) {
    for (std::size_t level = 0; level < level_names.size(); ++level) {
      const auto result = find(level_names[level]);
      if (result == levels.end() || result->state != State::passed) continue;
      for (const Level base : rests_on(static_cast<Level>(level))) {
        if (find(level_names[base])->state == State::passed) continue;
        result->state = State::unsupported;
        result->findings.push_back({"", "its own rules hold, but it rests on level " + std::string(level_names[base])});
        break;
      }
    }
  }
}

}  // namespace

Outcome check(std::string_view text, const std::vector<std::string>& selected) {
  Outcome outcome;
  try {
    const Certificate certificate(text);
    std::array<bool, level_names.size()> chosen = certificate.document.claimed;
    if (!selected.empty()) chosen.fill(false);
    for (const std::string& name : selected) {
      std::size_t level = 0;
      while (level < level_names.size() && level_names[level] != name) ++level;
      if (level == level_names.size() || !certificate.document.claimed[level])
        throw std::invalid_argument("level " + name + " is not claimed");
      select(chosen, static_cast<Level>(level));
    }
    for (std::size_t level = 0; level < level_names.size(); ++level) {
      if (chosen[level]) {
        outcome.levels.push_back(run_level(certificate, level));
      } else if (certificate.document.claimed[level]) {
        outcome.unchecked.emplace_back(level_names[level]);
      }
    }
    withdraw_unsupported(outcome.levels);
    const auto any = [&](State state) {
      return std::any_of(outcome.levels.begin(), outcome.levels.end(),
                         [=](const LevelResult& r) { return r.state == state; });
    };
    outcome.status = any(State::rejected) ? 1 : any(State::undecided) ? 2 : 0;
  } catch (const Malformed& reason) {
    outcome.status = 3;
    outcome.malformed = Finding{reason.rule, reason.what()};
  }
  return outcome;
}

}  // namespace delcert::checker
