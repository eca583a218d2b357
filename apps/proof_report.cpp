#include "apps/proof_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;
using Point = std::map<std::string, Rational>;

std::string point_text(const Point& point) {
  std::string result;
  for (const auto& [name, value] : point) result += (result.empty() ? "" : ", ") + name + " = " + exact_text(value);
  return result;
}

Json point_json(const Point& point) {
  Json result = Json::object();
  for (const auto& [name, value] : point) result[name] = exact_text(value);
  return result;
}

/// What is said of a step besides its verdict.
std::string detail_of(const StepOutcome& outcome, const Vacuity& vacuity) {
  if (is_refuted(outcome.verdict)) {
    return outcome.counterexample.empty() ? "false" : "false at " + point_text(outcome.counterexample);
  }
  if (is_proved(outcome.verdict)) {
    if (is_proved(vacuity.verdict)) return "never: " + vacuity.premises;
    return is_undecided(vacuity.verdict) ? "undecided whether ever: " + vacuity.premises : "";
  }
  if (outcome.left.empty()) return "";
  return (outcome.left.size() > 1 ? "left among others: " : "left: ") + outcome.left.front();
}

std::string text_or_dash(const std::optional<Rational>& x) { return x ? exact_text(*x) : "–"; }
Json text_or_null(const std::optional<Rational>& x) { return x ? Json(exact_text(*x)) : Json(nullptr); }

}  // namespace

std::string step_table_head() {
  return "| step | lines | status | method | verdict | boxes | seconds | |\n|---|---|---|---|---|--:|--:|---|\n";
}

std::string slack_table_head() {
  return "| step | constant | stated | proved with | refuted with | attempts |\n|---|---|---|---|---|--:|\n";
}

std::string_view verdict_text(const StepOutcome& outcome, const Vacuity& vacuity) {
  return is_proved(outcome.verdict) && is_proved(vacuity.verdict) ? "vacuous" : name_of(outcome.verdict);
}

std::string step_row(const Claim& claim, const Step& step, const StepOutcome& outcome, const Vacuity& vacuity,
                     double seconds) {
  return fmt::format("| {} / {} | {} | {} | {} | {} | {} | {:.2f} | {} |\n", claim.name, step.name, step.lines,
                     name_of(step.status), outcome.method, verdict_text(outcome, vacuity), outcome.boxes, seconds,
                     detail_of(outcome, vacuity));
}

std::string slack_row(const Claim& claim, const Step& step, const Slack& slack) {
  return fmt::format("| {} / {} | {} | {} | {} | {} | {} |\n", claim.name, step.name, slack.constant,
                     exact_text(slack.stated), text_or_dash(slack.proved), text_or_dash(slack.refuted), slack.attempts);
}

Json step_json(const Claim& claim, const Step& step, const StepOutcome& outcome, const Vacuity& vacuity) {
  Json result{{"claim", claim.name},      {"step", step.name},
              {"lines", step.lines},      {"status", name_of(step.status)},
              {"method", outcome.method}, {"verdict", verdict_text(outcome, vacuity)},
              {"boxes", outcome.boxes}};
  if (is_refuted(outcome.verdict)) result["counterexample"] = point_json(outcome.counterexample);
  if (is_undecided(outcome.verdict)) result["left"] = outcome.left;
  if (!is_proved(outcome.verdict)) return result;
  if (is_refuted(vacuity.verdict)) {
    result["point"] = point_json(vacuity.point);
  } else {
    result[is_proved(vacuity.verdict) ? "never" : "undecided_whether_ever"] = vacuity.premises;
  }
  return result;
}

Json slack_json(const Slack& slack) {
  Json result{{"constant", slack.constant},
              {"stated", exact_text(slack.stated)},
              {"proved", text_or_null(slack.proved)},
              {"refuted", text_or_null(slack.refuted)},
              {"sharp", slack.is_sharp()}};
  if (slack.refuted) result["counterexample"] = point_json(slack.counterexample);
  return result;
}

}  // namespace delcert
