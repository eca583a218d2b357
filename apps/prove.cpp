#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/claim_options.hpp"
#include "apps/commands.hpp"
#include "kernel/error.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/prover/prover.hpp"

namespace delcert {

namespace {

struct ProveOptions {
  ClaimOptions claims;
  std::vector<std::string> steps;
  bool json = false;
};

std::string point_text(const std::map<std::string, Rational>& point) {
  std::string result;
  for (const auto& [name, value] : point) result += (result.empty() ? "" : ", ") + name + " = " + exact_text(value);
  return result;
}

/// What is said of a step beside its verdict.
std::string detail(const StepOutcome& outcome) {
  if (is_refuted(outcome.verdict)) {
    return outcome.counterexample.empty() ? "false" : "false at " + point_text(outcome.counterexample);
  }
  if (is_proved(outcome.verdict) || outcome.left.empty()) return "";
  return (outcome.left.size() > 1 ? "left among others: " : "left: ") + outcome.left.front();
}

nlohmann::ordered_json json_of(const Claim& claim, const Step& step, const StepOutcome& outcome) {
  nlohmann::ordered_json result{{"claim", claim.name},      {"step", step.name},
                                {"lines", step.lines},      {"status", name_of(step.status)},
                                {"method", outcome.method}, {"verdict", name_of(outcome.verdict)},
                                {"boxes", outcome.boxes}};
  if (is_refuted(outcome.verdict)) {
    nlohmann::ordered_json point = nlohmann::ordered_json::object();
    for (const auto& [name, value] : outcome.counterexample) point[name] = exact_text(value);
    result["counterexample"] = point;
  }
  if (is_undecided(outcome.verdict)) result["left"] = outcome.left;
  return result;
}

class Report {
 public:
  explicit Report(const ProveOptions& options) : options_(options) {}

  void prove_all() {
    if (!options_.json)
      std::cout
          << "| step | lines | status | method | verdict | boxes | seconds | |\n|---|---|---|---|---|--:|--:|---|\n";
    for (const Claim& claim : claims_of(options_.claims)) {
      for (const Step& step : claim.steps) {
        if (is_asked_for(step)) prove_one(claim, step);
      }
    }
    for (const std::string& name : options_.steps) {
      if (std::find(found_.begin(), found_.end(), name) == found_.end()) {
        throw InputError("no step of the claims named is called " + name);
      }
    }
    if (options_.json) std::cout << all_.dump(2) << "\n";
  }

  void print_totals() const {
    if (options_.json) return;
    std::cout << fmt::format("\n{} steps: {} proved, {} refuted, {} undecided\n", proved_ + refuted_ + undecided_,
                             proved_, refuted_, undecided_);
  }

  [[nodiscard]] ExitStatus status() const {
    if (refuted_ > 0) return ExitStatus::rejected;
    return undecided_ > 0 ? ExitStatus::undecided : ExitStatus::verified;
  }

 private:
  bool is_asked_for(const Step& step) {
    if (options_.steps.empty()) return true;
    if (std::find(options_.steps.begin(), options_.steps.end(), step.name) == options_.steps.end()) return false;
    found_.push_back(step.name);
    return true;
  }

  void prove_one(const Claim& claim, const Step& step) {
    const auto begin = std::chrono::steady_clock::now();
    const StepOutcome outcome = prove(step);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    ++(is_proved(outcome.verdict) ? proved_ : is_refuted(outcome.verdict) ? refuted_ : undecided_);
    if (options_.json) {
      all_.push_back(json_of(claim, step, outcome));
      return;
    }
    std::cout << fmt::format("| {} / {} | {} | {} | {} | {} | {} | {:.2f} | {} |\n", claim.name, step.name, step.lines,
                             name_of(step.status), outcome.method, name_of(outcome.verdict), outcome.boxes,
                             seconds.count(), detail(outcome))
              << std::flush;
  }

  const ProveOptions& options_;
  std::vector<std::string> found_;
  nlohmann::ordered_json all_ = nlohmann::ordered_json::array();
  std::size_t proved_ = 0;
  std::size_t refuted_ = 0;
  std::size_t undecided_ = 0;
};

ExitStatus run_prove(const ProveOptions& options) {
  Report report(options);
  report.prove_all();
  report.print_totals();
  return report.status();
}

}  // namespace

void add_prove(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<ProveOptions>();
  CLI::App* command = program.add_subcommand("prove", "Prove the numeric steps of claims for all parameters");
  command->add_option("claims", options->claims.names,
                      "Claims: names of the library (delcert claims lists them) or TOML files");
  command->add_flag("--all", options->claims.all, "All files of the library");
  command->add_option("--step", options->steps, "Only the step of this name; may be repeated");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Exit status: 0 all proved, 1 one refuted, 2 one undecided and none refuted.\n\n"
      "Examples:\n"
      "  delcert prove --all\n"
      "  delcert prove my-steps.toml --step ratio");
  command->callback([options, &chosen] { chosen = [options] { return run_prove(*options); }; });
}

}  // namespace delcert
