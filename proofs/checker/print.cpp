#include "proofs/checker/print.hpp"

#include <cstdio>

namespace delcert::checker {
namespace {

/// The word "verified" is kept for runs in which everything is.
std::string state_name(const Outcome& outcome, const LevelResult& result) {
  switch (result.state) {
    case LevelResult::State::passed:
      return outcome.status == 0 ? "verified" : "passed";
    case LevelResult::State::rejected:
      return "REJECTED";
    case LevelResult::State::undecided:
      return "undecided";
    default:
      return "unsupported";
  }
}

constexpr const char* status_name(int status) {
  constexpr const char* names[] = {"verified", "rejected", "undecided", "malformed"};
  return names[status];
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.resize(width, ' ');
  return text;
}

std::string seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

std::string described(const Finding& finding) {
  return (finding.rule.empty() ? "" : finding.rule + ": ") + finding.what;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    char escape[8];
    if (static_cast<unsigned char>(c) < 0x20) {
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
      result += escape;
    } else {
      if (c == '"' || c == '\\') result += '\\';
      result += c;
    }
  }
  return result + "\"";
}

template <class Items, class Print>
std::string listed(const Items& items, const Print& print, const std::string& separator = ",") {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "" : separator) + print(item);
  return text;
}

std::string finding_json(const Finding& finding) {
  return "{\"rule\":" + quoted(finding.rule) + ",\"what\":" + quoted(finding.what) + "}";
}

}  // namespace

std::string as_text(const Outcome& outcome) {
  if (outcome.malformed) return "malformed: " + described(*outcome.malformed) + "\n";
  std::string text, names;
  for (const LevelResult& result : outcome.levels) {
    const std::string head = padded("level " + result.level, 11) + padded(state_name(outcome, result), 12);
    if (result.findings.empty()) text += head + result.summary + " (" + seconds(result.seconds) + " s)\n";
    for (const Finding& finding : result.findings) text += head + described(finding) + "\n";
  }
  const std::string levels = listed(
      outcome.levels, [](const LevelResult& r) { return r.level; }, ", ");
  text += std::string(status_name(outcome.status)) + ": levels " + levels;
  if (!outcome.unchecked.empty())
    text += "; claimed but not checked: " + listed(
                                                outcome.unchecked, [](const std::string& s) { return s; }, ", ");
  return text + "\n";
}

std::string as_json(const std::string& file, const Outcome& outcome) {
  const auto level = [&](const LevelResult& result) {
    return "{\"level\":" + quoted(result.level) + ",\"state\":" + quoted(state_name(outcome, result)) +
           ",\"summary\":" + quoted(result.summary) + ",\"seconds\":" + seconds(result.seconds) + ",\"findings\":[" +
           listed(result.findings, finding_json) + "]}";
  };
  return "{\"file\":" + quoted(file) + ",\"status\":" + quoted(status_name(outcome.status)) +
         ",\"exit\":" + std::to_string(outcome.status) +
         ",\"malformed\":" + (outcome.malformed ? finding_json(*outcome.malformed) : "null") + ",\"levels\":[" +
         listed(outcome.levels, level) + "],\"unchecked\":[" + listed(outcome.unchecked, quoted) + "]}\n";
}

}  // namespace delcert::checker
