#include "apps/attack_outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/claim_options.hpp"
#include "kernel/number/exact_text.hpp"
#include "properties/attack/attack_report.hpp"
#include "properties/attack/twins.hpp"
#include "support/atomic_file.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// One for each conclusion of each claim that was refuted: the first violation in the first shape where there is one,
/// made simpler.
std::vector<Refutation> refutations_of(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                                       const OutcomeOptions& options, const Progress& progress) {
  std::vector<Refutation> result;
  std::set<std::pair<std::string, std::string>> seen;
  for (std::size_t at = 0; at < targets.size(); ++at) {
    const Claim& claim = targets[at].claim;
    for (std::size_t conclusion = 0; conclusion < tallies[at].conclusions.size(); ++conclusion) {
      const ConclusionTally& tally = tallies[at].conclusions[conclusion];
      const std::string& name = claim.conclusions[conclusion].name;
      if (tally.violated == 0 || !seen.emplace(claim.name, name).second) continue;
      const auto instance = sample_instance(claim, targets[at].shape, options.seed, tally.first_violation);
      const Witness witness = shrunk_witness(claim, conclusion, instance.value().bindings, progress);
      result.push_back({claim.name, name, targets[at].shape, tally.first_violation, witness_text(witness), ""});
      if (options.witnesses.empty()) continue;
      result.back().file = write_witness(options.witnesses, witness_file_name(claim, name), result.back().witness);
    }
  }
  return result;
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

/// How often the points of a claim about points of its own could be drawn.
struct PointDraws {
  std::string claim;
  std::uint64_t samples = 0;
  std::uint64_t drawn = 0;
  Rational least;
  [[nodiscard]] bool is_hardly_drawn() const {
    return Rational(static_cast<long>(drawn)) < least * Rational(static_cast<long>(samples));
  }
};

std::vector<PointDraws> point_draws(const std::vector<Target>& targets, const std::vector<Tally>& tallies) {
  std::vector<PointDraws> result;
  for (std::size_t at = 0; at < targets.size(); ++at) {
    const Claim& claim = targets[at].claim;
    if (!claim.points) continue;
    if (result.empty() || result.back().claim != claim.name) {
      result.push_back({claim.name, 0, 0, claim.points->least_acceptance});
    }
    result.back().samples += tallies[at].samples;
    result.back().drawn += tallies[at].samples - tallies[at].not_drawn;
  }
  return result;
}

double percent(std::uint64_t part, std::uint64_t whole) {
  constexpr double hundred = 100;
  return whole == 0 ? 0 : hundred * static_cast<double>(part) / static_cast<double>(whole);
}

std::string draws_text(const PointDraws& draws) {
  std::string result = fmt::format("points: {}, {} of {} draws met the constraints ({:.1f} %)", draws.claim,
                                   draws.drawn, draws.samples, percent(draws.drawn, draws.samples));
  if (draws.is_hardly_drawn()) result += ", hardly any: least_acceptance is " + exact_text(draws.least);
  return result + "\n";
}

void print_json(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                const std::vector<Refutation>& refutations, const OutcomeOptions& options) {
  nlohmann::ordered_json json{{"seed", options.seed},
                              {"least_instances", options.least},
                              {"targets", attack_json(targets, tallies, options.least)},
                              {"totals", totals_json(attack_totals(targets, tallies), options.least)}};
  json["refutations"] = nlohmann::ordered_json::array();
  for (const Refutation& one : refutations) {
    json["refutations"].push_back({{"sample", one.sample}, {"witness", nlohmann::ordered_json::parse(one.witness)}});
  }
  const auto draws = point_draws(targets, tallies);
  for (const PointDraws& one : draws) {
    json["points"].push_back({{"claim", one.claim},
                              {"samples", one.samples},
                              {"drawn", one.drawn},
                              {"least_acceptance", exact_text(one.least)},
                              {"hardly_drawn", one.is_hardly_drawn()}});
  }
  std::cout << json.dump(1) << "\n";
}

void print_text(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                const std::vector<Refutation>& refutations, const OutcomeOptions& options) {
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
  for (const PointDraws& draws : point_draws(targets, tallies)) std::cout << "\n" << draws_text(draws);
}

}  // namespace

ExitStatus report_outcome(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                          const OutcomeOptions& options, const Progress& progress) {
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
  const auto draws = point_draws(targets, tallies);
  const bool hardly_drawn =
      std::any_of(draws.begin(), draws.end(), [](const PointDraws& one) { return one.is_hardly_drawn(); });
  return undecided || hardly_attacked || hardly_drawn ? ExitStatus::undecided : ExitStatus::verified;
}

std::string write_witness(const std::string& folder, const std::string& name, const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(folder) / name;
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw InputError("--witnesses " + folder + ": " + failure.message());
  write_file_atomically(path, text);
  return path.string();
}

}  // namespace delcert
