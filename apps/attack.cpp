#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/attack_report.hpp"
#include "apps/claim_options.hpp"
#include "apps/commands.hpp"
#include "apps/progress_line.hpp"
#include "kernel/error.hpp"
#include "proofs/certificate/atomic_file.hpp"
#include "properties/attack/shrink.hpp"
#include "properties/attack/witness.hpp"

namespace delcert {

namespace {

struct AttackOptions {
  ClaimOptions claims;
  std::uint64_t samples = 1000;
  std::uint64_t seed = 0;
  unsigned threads = 0;
  std::string log;
  std::string witnesses;
  std::string replay;
  bool twins = false;
  bool json = false;
};

/// The twins of a claim that have to be refuted.
std::vector<Claim> twins_of(const Claim& claim) {
  std::vector<Claim> result;
  for (std::size_t at = 0; at < claim.conclusions.size(); ++at) {
    if (claim.conclusions[at].twin) result.push_back(twin_of_conclusion(claim, at));
  }
  for (std::size_t at = 0; at < claim.hypotheses.size(); ++at) {
    if (claim.hypotheses[at].no_twin.empty()) result.push_back(twin_of_hypothesis(claim, at));
  }
  return result;
}

std::vector<Target> targets_of(const AttackOptions& options) {
  std::vector<Target> result;
  for (const Claim& claim : claims_of(options.claims)) {
    for (const Claim& one : options.twins ? twins_of(claim) : std::vector<Claim>{claim}) {
      for (const Shape& shape : shapes_of(options.claims, one)) {
        const std::uint64_t cost = instance_class(one.instance).cost(shape);
        result.push_back({one, shape, (options.samples + cost - 1) / cost});
      }
    }
  }
  return result;
}

/// What to call a claim in a witness so that a replay finds it again.
std::string reference_of(const Claim& claim) {
  const std::string original = claim.name.substr(0, claim.name.find('/'));
  return claim.file == "proofs/claims/" + original + ".toml" ? original : claim.file;
}

std::string twin_of(const Claim& claim) {
  const std::size_t slash = claim.name.find('/');
  return slash == std::string::npos ? "" : claim.name.substr(slash + 1);
}

/// The first violation of a conclusion, made simpler.
Refutation refutation_of(const Target& target, const Tally& tally, std::size_t conclusion, std::uint64_t seed) {
  const Claim& claim = target.claim;
  const std::uint64_t sample = tally.conclusions[conclusion].first_violation;
  const auto instance = sample_instance(claim, target.shape, seed, sample);
  const auto is_violated = [&](const Bindings& bindings) {
    const Attempt result = attempt(claim, bindings);
    return is_proved(result.hypotheses) && is_refuted(result.conclusions[conclusion].verdict);
  };
  const InstanceClass& its_class = instance_class(claim.instance);
  Witness witness{reference_of(claim), claim.conclusions[conclusion].name, twin_of(claim), claim.instance,
                  shrunk(its_class, instance.value().bindings, is_violated)};
  return {claim.name, witness.conclusion, target.shape, sample, witness_text(witness), ""};
}

/// One for each conclusion of each claim that was refuted, in the first shape where it was.
std::vector<Refutation> refutations_of(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                                       const AttackOptions& options) {
  std::vector<Refutation> result;
  std::set<std::pair<std::string, std::string>> seen;
  for (std::size_t at = 0; at < targets.size(); ++at) {
    for (std::size_t conclusion = 0; conclusion < tallies[at].conclusions.size(); ++conclusion) {
      const Claim& claim = targets[at].claim;
      if (tallies[at].conclusions[conclusion].violated == 0) continue;
      if (!seen.emplace(claim.name, claim.conclusions[conclusion].name).second) continue;
      result.push_back(refutation_of(targets[at], tallies[at], conclusion, options.seed));
      if (options.witnesses.empty()) continue;
      std::string stem = result.back().claim + "." + result.back().conclusion;
      std::replace(stem.begin(), stem.end(), '/', '.');
      const std::filesystem::path path = std::filesystem::path(options.witnesses) / (stem + ".json");
      std::filesystem::create_directories(options.witnesses);
      write_file_atomically(path, result.back().witness);
      result.back().file = path.string();
    }
  }
  return result;
}

/// The claim or twin that a witness speaks of.
Claim claim_of(const Witness& witness) {
  const Claim claim = find_claim(witness.claim);
  if (witness.twin.empty()) return claim;
  for (Claim& twin : twins_of(claim)) {
    if (twin_of(twin) == witness.twin) return std::move(twin);
  }
  throw InputError("the claim " + witness.claim + " has no twin " + witness.twin);
}

ExitStatus replay(const AttackOptions& options) {
  const Witness witness = read_witness(options.replay);
  const Claim claim = claim_of(witness);
  if (claim.instance != witness.instance_class) {
    throw InputError(options.replay + ": the claim " + claim.name + " is about the class " + claim.instance);
  }
  const Attempt result = attempt(claim, witness.bindings);
  std::cout << claim.name << ": the hypotheses are " << name_of(result.hypotheses) << "\n";
  for (std::size_t at = 0; at < result.conclusions.size(); ++at) {
    if (claim.conclusions[at].name != witness.conclusion) continue;
    const ConclusionOutcome& outcome = result.conclusions[at];
    std::cout << claim.conclusions[at].text << ": " << name_of(outcome.verdict) << ", ratio "
              << ratio_text(outcome.ratio) << "\n";
    if (is_refuted(outcome.verdict)) return ExitStatus::rejected;
    return is_proved(outcome.verdict) ? ExitStatus::verified : ExitStatus::undecided;
  }
  if (is_refuted(result.hypotheses)) return ExitStatus::verified;
  if (is_undecided(result.hypotheses)) return ExitStatus::undecided;
  throw InputError(options.replay + ": the claim " + claim.name + " has no conclusion " + witness.conclusion);
}

/// All twins have to be refuted.
ExitStatus report_twins(const std::vector<Target>& targets, const std::vector<Tally>& tallies) {
  std::map<std::string, bool> refuted;
  for (std::size_t at = 0; at < targets.size(); ++at) {
    bool& one = refuted[targets[at].claim.name];
    one = one || tallies[at].is_refuted();
  }
  std::size_t count = 0;
  for (const auto& [name, is_refuted] : refuted) {
    count += is_refuted ? 1U : 0U;
    if (!is_refuted) std::cout << "not refuted: " << name << "\n";
  }
  std::cout << count << " of " << refuted.size() << " twins refuted\n";
  return count == refuted.size() ? ExitStatus::verified : ExitStatus::rejected;
}

ExitStatus report(const std::vector<Target>& targets, const std::vector<Tally>& tallies, const AttackOptions& options) {
  const auto refutations = refutations_of(targets, tallies, options);
  if (options.json) {
    nlohmann::ordered_json json{{"seed", options.seed}, {"targets", attack_json(targets, tallies)}};
    json["refutations"] = nlohmann::ordered_json::array();
    for (const Refutation& one : refutations) {
      json["refutations"].push_back({{"sample", one.sample}, {"witness", nlohmann::ordered_json::parse(one.witness)}});
    }
    std::cout << json.dump(1) << "\n";
  } else {
    std::cout << attack_table(targets, tallies);
  }
  if (options.twins) return report_twins(targets, tallies);
  std::uint64_t undecided = 0;
  for (const Tally& tally : tallies) undecided += tally.undecided();
  for (const Refutation& one : refutations) {
    if (options.json) break;
    std::cout << "\nrefuted: " << one.claim << " / " << one.conclusion << " in " << text_of(one.shape) << ", sample "
              << one.sample << (one.file.empty() ? "" : ", " + one.file) << "\n"
              << one.witness;
  }
  if (!refutations.empty()) return ExitStatus::rejected;
  return undecided > 0 ? ExitStatus::undecided : ExitStatus::verified;
}

ExitStatus run_attack(const AttackOptions& options) {
  if (!options.replay.empty()) return replay(options);
  CampaignPlan plan;
  plan.targets = targets_of(options);
  plan.seed = options.seed;
  plan.threads = options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
  plan.log = options.log;
  constexpr std::uint64_t largest = std::numeric_limits<std::uint32_t>::max();
  if (options.samples == 0 || options.samples > largest) throw InputError("--samples wants 1 to 4294967295");
  std::vector<Tally> tallies;
  {
    ProgressLine line;
    tallies = run_campaign(plan, line.callback());
  }
  return report(plan.targets, tallies, options);
}

}  // namespace

void add_attack(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<AttackOptions>();
  CLI::App* command = program.add_subcommand("attack", "Attack claims on random instances, with exact decisions");
  add_claim_options(*command, options->claims);
  command->add_option("--samples", options->samples,
                      "Samples for each claim and shape (default 1000; less where an instance is costly)");
  command->add_option("--seed", options->seed, "Seed of the random choices (default 0)");
  command->add_option("--threads", options->threads, "Threads (default: all; the result does not depend on it)");
  command->add_option("--log", options->log, "JSON lines, one for each finished block; a campaign goes on from there");
  command->add_option("--witnesses", options->witnesses, "Folder for witness files of what is refuted");
  command->add_option("--replay", options->replay, "Decide again what this witness file says");
  command->add_flag("--twins", options->twins, "Attack the twins, which all have to be refuted, instead of the claims");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Exit status: 0 everything held (with --twins: all refuted), 1 something is refuted, 2 something is "
      "undecided.\n\n"
      "Examples:\n"
      "  delcert attack thickness-and-singular-value --samples 10000 --seed 1\n"
      "  delcert attack my-claim.toml --shape 2,2 --shape 2,3 --witnesses found\n"
      "  delcert attack --all --samples 10000 --log campaign.jsonl\n"
      "  delcert attack --replay found/my-claim.conclusion-1.json");
  command->callback([options, &chosen] { chosen = [options] { return run_attack(*options); }; });
}

}  // namespace delcert
