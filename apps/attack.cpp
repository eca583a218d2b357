#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/claim_commands.hpp"
#include "apps/claim_options.hpp"
#include "apps/interruption.hpp"
#include "apps/progress_line.hpp"
#include "properties/attack/attack_report.hpp"
#include "properties/attack/refutations.hpp"
#include "properties/attack/replay.hpp"
#include "properties/attack/twins.hpp"
#include "support/atomic_file.hpp"
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
  bool twins = false;
  bool stored = false;
  bool is_short = false;
  bool json = false;
  bool latex = false;
};

constexpr std::uint64_t most_samples = 10000000000;

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

std::string write_witness(const std::string& folder, const std::string& name, const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(folder) / name;
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw InputError("--witnesses " + folder + ": " + failure.message());
  write_file_atomically(path, text);
  return path.string();
}

std::vector<Refutation> refutations_of(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                                       const AttackOptions& options, const Progress& progress) {
  std::vector<Refutation> result;
  for (const FoundRefutation& found : refutations_in(targets, tallies, options.seed, progress)) {
    const auto& [claim, shape, samples] = targets[found.target];
    const std::string& name = claim.conclusions[found.conclusion].name;
    result.push_back({claim.name, name, shape, found.sample, witness_text(found.witness), ""});
    if (options.witnesses.empty()) continue;
    result.back().file = write_witness(options.witnesses, witness_file_name(claim, name), result.back().witness);
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

/// Claims none of whose samples met the hypotheses, in any shape.
std::vector<std::string> never_met(const std::vector<Target>& targets, const std::vector<Tally>& tallies) {
  std::map<std::string, std::uint64_t> met;
  for (std::size_t at = 0; at < targets.size(); ++at) met[targets[at].claim.name] += tallies[at].met();
  std::vector<std::string> result;
  for (const auto& [name, count] : met) {
    if (count == 0) result.push_back(name);
  }
  return result;
}

void print_json(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                const std::vector<Refutation>& refutations, const AttackOptions& options) {
  nlohmann::ordered_json json{{"seed", options.seed},
                              {"least_instances", options.least},
                              {"targets", attack_json(targets, tallies, options.least)},
                              {"totals", totals_json(attack_totals(targets, tallies), options.least)}};
  json["refutations"] = nlohmann::ordered_json::array();
  for (const Refutation& one : refutations) {
    json["refutations"].push_back({{"sample", one.sample}, {"witness", nlohmann::ordered_json::parse(one.witness)}});
  }
  std::cout << json.dump(1) << "\n";
}

void print_text(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                const std::vector<Refutation>& refutations, const AttackOptions& options) {
  std::cout << attack_table(targets, tallies, options.least, options.is_short);
  const std::string totals = totals_text(attack_totals(targets, tallies), options.least);
  if (!totals.empty()) std::cout << "\n" << totals;
  for (const Refutation& one : refutations) {
    std::cout << "\nrefuted: " << one.claim << " / " << one.conclusion << " in " << text_of(one.shape) << ", sample "
              << one.sample << (one.file.empty() ? "" : ", " + one.file) << "\n"
              << one.witness;
  }
  for (const std::string& name : never_met(targets, tallies)) {
    std::cout << "\nnot attacked: " << name << ", no sample met its hypotheses\n";
  }
}

ExitStatus report(const std::vector<Target>& targets, const std::vector<Tally>& tallies, const AttackOptions& options,
                  const Progress& progress) {
  const auto refutations = refutations_of(targets, tallies, options, progress);
  if (options.json) {
    print_json(targets, tallies, refutations, options);
  } else if (options.latex) {
    std::cout << attack_latex(targets, tallies, options.least, options.is_short);
  } else {
    print_text(targets, tallies, refutations, options);
  }
  if (!refutations.empty()) return ExitStatus::rejected;
  const bool undecided =
      std::any_of(tallies.begin(), tallies.end(), [](const Tally& tally) { return tally.undecided() > 0; });
  const auto totals = attack_totals(targets, tallies);
  const bool hardly_attacked = std::any_of(totals.begin(), totals.end(), [&](const AttackTotal& total) {
    return total.tally.held == 0 || total.tally.held < options.least;
  });
  return undecided || hardly_attacked ? ExitStatus::undecided : ExitStatus::verified;
}

ExitStatus run_attack(const AttackOptions& options) {
  if (options.latex && !options.replay.empty()) throw InputError("--latex is for campaigns, not for --replay");
  if (!options.replay.empty()) return replay_witness(options);
  if (options.samples == 0 || options.samples > most_samples) throw InputError("--samples takes 1 to 10^10");
  if (options.latex && options.twins) throw InputError("--latex is for campaigns, not for --twins");
  if (options.twins) return attack_twins(options);
  if (options.stored) throw InputError("--stored needs --twins");
  CampaignPlan plan;
  plan.targets = targets_of(options);
  if (plan.targets.empty()) throw InputError("no claim is about a class with this --shape");
  plan.seed = options.seed;
  plan.threads = options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
  plan.log = options.log;
  ProgressLine line;
  const InterruptionDeadline deadline(options.log.empty() ? Interrupted().what()
                                                          : InterruptedWithLog(options.log).what());
  std::vector<Tally> tallies;
  try {
    tallies = run_campaign(plan, line.callback());
  } catch (const Interrupted&) {
    if (options.log.empty()) throw;
    throw InterruptedWithLog(options.log);
  }
  line.clear();
  return report(plan.targets, tallies, options, line.callback());
}

}  // namespace

void add_attack(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<AttackOptions>();
  CLI::App* command = add_named(program, about_attack);
  add_claim_options(*command, options->claims);
  command->add_option("--samples", options->samples,
                      "Samples for each claim and shape (default 1000; fewer where an instance is costly)");
  command->add_option("--least", options->least,
                      "With fewer instances than this, a conclusion counts as hardly attacked (default 100)");
  command->add_option("--seed", options->seed, "Seed of the random choices (default 0)");
  command->add_option("--threads", options->threads, "Threads (default: all; the result does not depend on it)");
  command->add_option("--log", options->log, "JSON lines, one for each finished block; a campaign goes on from there");
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
      "refuted, 2 something is undecided or hardly attacked.\n"
      "With --twins: 0 all are refuted, 1 some are not.\n\n"
      "Examples:\n"
      "  delcert attack thickness-and-singular-value --samples 10000 --seed 1\n"
      "  delcert attack my-claim.toml --shape 2,2 --shape 2,3 --witnesses found\n"
      "  delcert attack --all --samples 10000 --log campaign.jsonl\n"
      "  delcert attack --replay found/my-claim.conclusion-1.json");
  command->callback([options, &chosen] { chosen = [options] { return run_attack(*options); }; });
}

}  // namespace delcert
