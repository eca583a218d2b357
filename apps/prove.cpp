#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/claim_options.hpp"
#include "apps/interruption.hpp"
#include "apps/other_programs.hpp"
#include "apps/proof_report.hpp"
#include "proofs/prover/proof_log.hpp"
#include "properties/attack/claim_text.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct ProveOptions {
  ClaimOptions claims;
  std::vector<std::string> steps;
  bool json = false;
  bool slack = false;
  bool mutate = false;
  std::string log;
};

class Report {
 public:
  explicit Report(const ProveOptions& options) : options_(options) {}

  void run() {
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<Claim> claims = claims_of(options_.claims);
    if (!options_.claims.all) require_steps(claims);
    if (!options_.json) std::cout << step_table_head();
    for (const Claim& claim : claims) {
      std::string log;
      for (const Step& step : claim.steps) {
        if (is_asked_for(step)) prove_one(claim, step, log);
      }
      if (!options_.log.empty() && !log.empty()) {
        write_file_atomically(std::filesystem::path(options_.log) / (claim.name + ".jsonl"),
                              proof_log_head(claim.name, claim.file, file_text_of(claim)) + log);
      }
    }
    for (const std::string& name : options_.steps) {
      if (std::find(found_.begin(), found_.end(), name) == found_.end()) {
        throw InputError("no step of the claims named is called " + name);
      }
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    if (options_.json) {
      std::cout << nlohmann::ordered_json{{"steps", all_}}.dump(2) << "\n";
    } else {
      print_totals(seconds.count());
    }
  }

  [[nodiscard]] ExitStatus status() const {
    if (refuted_ > 0) return ExitStatus::rejected;
    if (vacuous_ > 0) return ExitStatus::vacuous;
    return undecided_ + perhaps_vacuous_ > 0 ? ExitStatus::undecided : ExitStatus::verified;
  }

 private:
  /// A file that was named and says nothing that can be proved is no success, whatever the others say.
  static void require_steps(const std::vector<Claim>& claims) {
    for (const Claim& claim : claims) {
      if (claim.steps.empty()) throw Undecided(claim.file + ": no [[step]], so there is nothing to prove");
    }
  }

  bool is_asked_for(const Step& step) {
    if (options_.steps.empty()) return true;
    if (std::find(options_.steps.begin(), options_.steps.end(), step.name) == options_.steps.end()) return false;
    found_.push_back(step.name);
    return true;
  }

  void prove_one(const Claim& claim, const Step& step, std::string& log) {
    const auto begin = std::chrono::steady_clock::now();
    const StepOutcome outcome = prove(step);
    const Vacuity vacuity = is_proved(outcome.verdict) ? vacuity_of(step) : Vacuity();
    const bool is_vacuous = is_proved(outcome.verdict) && is_proved(vacuity.verdict);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    ++(is_vacuous                    ? vacuous_
       : is_proved(outcome.verdict)  ? proved_
       : is_refuted(outcome.verdict) ? refuted_
                                     : undecided_);
    if (is_proved(outcome.verdict) && is_undecided(vacuity.verdict)) {
      ++perhaps_vacuous_;
      not_proved_ +=
          fmt::format("  undecided whether vacuous: {} / {} ({})\n", claim.name, step.name, name_of(step.status));
    }
    if (is_vacuous || !is_proved(outcome.verdict)) {
      not_proved_ += fmt::format("  {}: {} / {} ({})\n", verdict_text(outcome, vacuity), claim.name, step.name,
                                 name_of(step.status));
    }
    if (is_proved(outcome.verdict) && !is_vacuous && !options_.log.empty())
      log += proof_log_line(claim.name, step, step.constants, outcome);
    nlohmann::ordered_json json = step_json(claim, step, outcome, vacuity);
    if (options_.slack || options_.mutate) json["slack"] = slack_of_all(claim, step);
    if (options_.json) {
      all_.push_back(std::move(json));
    } else {
      std::cout << step_row(claim, step, outcome, vacuity, seconds.count()) << std::flush;
    }
  }

  nlohmann::ordered_json slack_of_all(const Claim& claim, const Step& step) {
    nlohmann::ordered_json result = nlohmann::ordered_json::array();
    for (const auto& [name, value] : step.constants) {
      const Slack slack = slack_of(step, name);
      slack_rows_ += slack_row(claim, step, slack);
      ++constants_;
      if (slack.proved && slack.refuted) ++moved_refuted_;
      if (slack.proved && !slack.refuted) any_ += fmt::format("  {} / {}: {}\n", claim.name, step.name, name);
      if (!slack.proved) never_ += fmt::format("  {} / {}: {}\n", claim.name, step.name, name);
      result.push_back(slack_json(slack));
    }
    return result;
  }

  void print_totals(double seconds) const {
    if (options_.slack) std::cout << "\n" << slack_table_head() << slack_rows_;
    std::cout << fmt::format("\n{} steps: {} proved, {} refuted, {} undecided, {} vacuous, {:.1f} s\n",
                             proved_ + refuted_ + undecided_ + vacuous_, proved_, refuted_, undecided_, vacuous_,
                             seconds);
    std::cout << not_proved_;
    if (!options_.mutate) return;
    const double share =
        constants_ == 0 ? 100 : 100.0 * static_cast<double>(moved_refuted_) / static_cast<double>(constants_);
    std::cout << fmt::format("{} constants moved past their slack: {} refuted with a counterexample ({:.1f} %)\n",
                             constants_, moved_refuted_, share);
    if (!any_.empty()) std::cout << "no value refuted:\n" << any_;
    if (!never_.empty()) std::cout << "no value proved:\n" << never_;
  }

  const ProveOptions& options_;
  std::vector<std::string> found_;
  nlohmann::ordered_json all_ = nlohmann::ordered_json::array();
  std::string not_proved_;
  std::string slack_rows_;
  std::string any_;
  std::string never_;
  std::size_t proved_ = 0;
  std::size_t refuted_ = 0;
  std::size_t undecided_ = 0;
  std::size_t vacuous_ = 0;
  std::size_t perhaps_vacuous_ = 0;  ///< of those that are proved
  std::size_t constants_ = 0;
  std::size_t moved_refuted_ = 0;
};

ExitStatus run_prove(const ProveOptions& options) {
  if (!options.log.empty() && !std::filesystem::is_directory(options.log)) {
    throw InputError("--log " + options.log + ": no such folder");
  }
  const InterruptionDeadline deadline;
  Report report(options);
  report.run();
  return report.status();
}

}  // namespace

void add_prove(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<ProveOptions>();
  CLI::App* command = add_named(program, about_prove);
  command->add_option("claims", options->claims.names,
                      "Claims: names of the library (delcert claims lists them) or TOML files");
  command->add_flag("--all", options->claims.all, "All files of the library");
  command->add_option("--step", options->steps, "Only the step of this name; may be repeated");
  command->add_flag("--slack", options->slack, "Also find the best value of each constant for which a step is proved");
  command->add_flag("--mutate", options->mutate, "Count the constants that are refuted once moved past their slack");
  command->add_option("--log", options->log, "Write a log of the proofs, for delcert-replay, into this folder");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Exit status: 0 all proved, 1 one refuted, else 4 one vacuous (its hypotheses contradict each other), else\n"
      "2 one undecided, or undecided whether it is vacuous; 3 a file without steps.\n\n"
      "Examples:\n"
      "  delcert prove --all\n"
      "  delcert prove my-steps.toml --step ratio --slack\n"
      "  delcert prove thickness-under-distortion --log logs && delcert-replay logs/thickness-under-distortion.jsonl");
  command->callback([options, &chosen] { chosen = [options] { return run_prove(*options); }; });
}

}  // namespace delcert
