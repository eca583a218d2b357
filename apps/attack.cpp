#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/attack_outcome.hpp"
#include "apps/campaign_options.hpp"
#include "apps/claim_options.hpp"
#include "apps/interruption.hpp"
#include "apps/other_programs.hpp"
#include "apps/progress_line.hpp"
#include "kernel/number/recycled_limbs.hpp"
#include "properties/attack/attack_report.hpp"
#include "properties/attack/refutations.hpp"
#include "properties/attack/replay.hpp"
#include "properties/attack/twins.hpp"
#include "support/duration.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

struct AttackOptions {
  ClaimOptions claims;
  std::uint64_t samples = 1000;
  std::uint64_t least = usual_least_instances;
  std::uint64_t seed = 0;
  unsigned threads = 0;
  std::string log;
  std::string witnesses;
  std::string replay;
  std::string part;
  std::string until;
  std::string progress_every;
  bool twins = false;
  bool stored = false;
  bool is_short = false;
  bool json = false;
  bool latex = false;

  [[nodiscard]] OutcomeOptions outcome() const { return {seed, least, witnesses, is_short, json, latex}; }
};

constexpr std::uint64_t most_samples = 10000000000;
constexpr std::chrono::seconds usual_progress_every(60);

std::vector<Target> targets_of(const AttackOptions& options) {
  std::vector<Target> result;
  for (const Claim& claim : claims_about_instances(options.claims)) {
    for (const Shape& shape : shapes_of(options.claims, claim)) {
      const std::uint64_t cost = std::max<std::uint64_t>(1, instance_class(claim.instance).cost(shape));
      result.push_back({claim, shape, (options.samples + cost - 1) / cost});
    }
  }
  return result;
}

ExitStatus replay_witness(const AttackOptions& options) {
  const InterruptionDeadline deadline;
  if (options.claims.all || options.claims.names.size() > 1 || options.twins) {
    throw InputError("--replay takes one witness, and at most one claim in place of the one that the witness names");
  }
  const Witness witness = read_witness(options.replay);
  std::optional<Replay> replay;
  try {
    replay = replayed(witness, options.claims.names.empty() ? "" : options.claims.names.front());
  } catch (const InputError& error) {
    throw InputError(options.replay + ": " + error.what());
  }
  if (!replay->remark.empty()) std::cout << replay->remark << "\n";
  std::cout << replay->claim.name << ": the hypotheses are " << name_of(replay->hypotheses) << "\n";
  if (const auto& conclusion = replay->conclusion) {
    std::cout << conclusion->text << ": " << name_of(conclusion->verdict) << ", ratio " << ratio_text(conclusion->ratio)
              << "\n";
    if (is_refuted(conclusion->verdict)) return ExitStatus::rejected;
    return is_proved(conclusion->verdict) ? ExitStatus::verified : ExitStatus::undecided;
  }
  return is_refuted(replay->hypotheses) ? ExitStatus::verified : ExitStatus::undecided;
}

/// What became of a twin, and of a conclusion that has none.
struct TwinRow {
  std::string name;
  std::string outcome;
  std::string file;
  bool is_refuted = false;
};

TwinRow attack_twin(const Claim& twin, const AttackOptions& options, const Progress& progress) {
  TwinRow row{twin.name, "not refuted", "", false};
  if (!options.witnesses.empty() && is_refuted_by_stored_witness(twin, options.witnesses)) {
    row.file = (std::filesystem::path(options.witnesses) / witness_file_name(twin, twin.conclusions[0].name)).string();
    return {twin.name, "refuted by a stored witness", row.file, true};
  }
  if (options.stored) return row;
  const Effort effort{options.samples, options.samples, options.seed};
  const auto witness = refute(twin, shapes_of(options.claims, twin), effort, progress);
  if (!witness) return row;
  if (!options.witnesses.empty()) {
    row.file = write_witness(options.witnesses, witness_file_name(twin, witness->conclusion), witness_text(*witness));
  }
  return {twin.name, "refuted", row.file, true};
}

void print(const std::vector<TwinRow>& rows, std::size_t refuted, bool json) {
  if (!json) {
    for (const TwinRow& row : rows) {
      if (!row.is_refuted) std::cout << row.outcome << ": " << row.name << "\n";
    }
    std::cout << refuted << " of " << rows.size() << " twins refuted\n";
    return;
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const TwinRow& row : rows) {
    list.push_back({{"twin", row.name}, {"refuted", row.is_refuted}, {"outcome", row.outcome}, {"file", row.file}});
  }
  std::cout << nlohmann::ordered_json{{"twins", list}}.dump(1) << "\n";
}

/// All twins have to be refuted, and every conclusion has one or says why not.
ExitStatus attack_twins(const AttackOptions& options) {
  if (!options.log.empty()) throw InputError("--log is for campaigns, not for --twins");
  std::vector<TwinRow> rows;
  {
    const InterruptionDeadline deadline;
    ProgressLine line;
    for (const Claim& claim : claims_about_instances(options.claims)) {
      for (const Claim& twin : twins_of(claim)) rows.push_back(attack_twin(twin, options, line.callback()));
      for (const std::string& name : conclusions_without_twin(claim)) {
        rows.push_back({claim.name + "/" + name, "neither twin nor reason", "", false});
      }
    }
  }
  const auto refuted = static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const TwinRow& row) { return row.is_refuted; }));
  print(rows, refuted, options.json);
  return refuted == rows.size() ? ExitStatus::verified : ExitStatus::rejected;
}

/// Of a part there is no table: what it found is part of the whole.
ExitStatus report_part(const AttackOptions& options, const CampaignOutcome& outcome, const Part& part) {
  if (options.json) {
    std::cout << nlohmann::ordered_json{{"part", {part.number, part.of}},
                                        {"blocks", outcome.blocks},
                                        {"finished", outcome.finished},
                                        {"log", options.log}}
                     .dump(1)
              << "\n";
  } else {
    std::cout << "part " << text_of(part) << ": " << outcome.finished << " of " << outcome.blocks
              << " blocks are finished in " << options.log << "\n";
  }
  return ExitStatus::verified;
}

Part part_from(const std::string& text) {
  if (text.empty()) return {};
  Part result;
  const std::size_t slash = text.find('/');
  const char* end = text.data() + text.size();
  const auto [first_end, first_error] = std::from_chars(text.data(), end, result.number);
  if (slash != std::string::npos && first_error == std::errc{} && first_end == text.data() + slash) {
    const auto [last_end, last_error] = std::from_chars(first_end + 1, end, result.of);
    if (last_error == std::errc{} && last_end == end && result.number >= 1 && result.number <= result.of) return result;
  }
  throw InputError("--part " + text + ": a part such as 3/8 was expected, from 1/8 to 8/8");
}

CampaignPlan plan_from(const AttackOptions& options) {
  CampaignPlan plan;
  plan.targets = targets_of(options);
  if (plan.targets.empty()) throw InputError("no claim is about a class with this --shape");
  plan.seed = options.seed;
  plan.part = part_from(options.part);
  plan.software = software_name();
  plan.threads = threads_or_all(options.threads);
  plan.log = options.log;
  return plan;
}

std::optional<std::chrono::seconds> duration_from(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  try {
    return parse_duration(text);
  } catch (const InputError& error) {
    throw InputError(option + " " + error.what());
  }
}

void require_log_for(const AttackOptions& options) {
  for (const auto& [name, value] : {std::pair("--part", options.part), std::pair("--until", options.until)}) {
    if (!value.empty() && options.log.empty()) throw InputError(std::string(name) + " needs a --log to go on from");
  }
}

ExitStatus run_attack(const AttackOptions& options) {
  const RecycledLimbs recycled;
  if (options.latex && !options.replay.empty()) throw InputError("--latex is for campaigns, not for --replay");
  if (!options.replay.empty()) return replay_witness(options);
  if (options.samples == 0 || options.samples > most_samples) throw InputError("--samples takes 1 to 10^10");
  if (options.latex && options.twins) throw InputError("--latex is for campaigns, not for --twins");
  if (options.twins) return attack_twins(options);
  if (options.stored) throw InputError("--stored needs --twins");
  require_log_for(options);
  const auto limit = duration_from("--until", options.until);
  const auto every = duration_from("--progress-every", options.progress_every);
  const CampaignPlan plan = plan_from(options);
  ProgressLine line;
  if (!options.log.empty()) line.also_without_terminal(every.value_or(usual_progress_every));
  const InterruptionDeadline deadline(options.log.empty() ? Interrupted().what()
                                                          : InterruptedWithLog(options.log).what());
  CampaignOutcome outcome;
  try {
    outcome = run_campaign(plan, line.callback(), limit);
  } catch (const Interrupted&) {
    if (options.log.empty()) throw;
    throw InterruptedWithLog(options.log);
  }
  line.clear();
  if (!outcome.is_finished()) {
    throw Undecided("not finished: " + std::to_string(outcome.finished) + " of " + std::to_string(outcome.blocks) +
                    " blocks after " + options.until + "; the same command goes on from them, in " + options.log);
  }
  decide_anew(options.log, outcome.plan, outcome.records, plan.threads, line.callback());
  line.clear();
  if (!options.part.empty()) return report_part(options, outcome, plan.part);
  return report_outcome(plan.targets, outcome.tallies, options.outcome(), line.callback());
}

}  // namespace

void add_attack(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<AttackOptions>();
  CLI::App* command = add_named(program, about_attack);
  add_claim_options(*command, options->claims);
  command->add_option("--samples", options->samples,
                      "Samples for each claim and shape (default 1000; fewer where an instance is costly)");
  command->add_option("--least,--least-instances", options->least,
                      "With fewer instances than this, a conclusion counts as hardly attacked (default 100)");
  command->add_option("--seed", options->seed, "Seed of the random choices (default 0)");
  command->add_option("--threads", options->threads, "Threads (default: all; the result does not depend on it)");
  command->add_option("--log", options->log, "JSON lines, one for each finished block; a campaign goes on from there");
  command->add_option("--part", options->part,
                      "i/n: only the i-th of n parts, into its --log; delcert campaign merge puts them together");
  command->add_option("--until", options->until,
                      "Begin no block after this time (90s, 45min, 8h, 2d); status 2 if that was not all");
  command->add_option("--progress-every", options->progress_every,
                      "With --log and without a terminal: a line on standard error so often (default 60s)");
  command->add_option("--witnesses", options->witnesses,
                      "Folder for witness files; with --twins, a twin that a witness there refutes is not attacked");
  command->add_option("--replay", options->replay,
                      "Decide this witness file anew, for the claim that it names or for CLAIM");
  command->add_flag("--twins", options->twins, "Attack the twins, which all have to be refuted, instead of the claims");
  command->add_flag("--stored", options->stored,
                    "With --twins: decide only the witnesses in the folder, search for nothing");
  command->add_flag("--short", options->is_short, "A row of the table for all shapes of the same k");
  CLI::Option* json = command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--latex", options->latex, "Print the table in LaTeX (longtable, booktabs), and nothing else")
      ->excludes(json);
  command->footer(
      "Exit status: 0 nothing is refuted, by at least 100 instances for each conclusion (or --least), 1 something is\n"
      "refuted, 2 something is undecided or hardly attacked, or --until came before the end.\n"
      "With --twins: 0 all are refuted, 1 some are not.\n\n"
      "Examples:\n"
      "  delcert attack thickness-and-singular-value --samples 10000 --seed 1\n"
      "  delcert attack my-claim.toml --shape 2,2 --shape 2,3 --witnesses found\n"
      "  delcert attack --all --samples 10000 --log campaign.jsonl\n"
      "  delcert attack --all --samples 10000 --part 3/8 --log part-3.jsonl --until 8h\n"
      "  delcert attack --replay found/my-claim.conclusion-1.json");
  command->callback([options, &chosen] { chosen = [options] { return run_attack(*options); }; });
}

}  // namespace delcert
