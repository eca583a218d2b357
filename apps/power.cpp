#include "properties/attack/power.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/interruption.hpp"
#include "apps/other_programs.hpp"
#include "apps/progress_line.hpp"
#include "apps/search_options.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/tables/powers.hpp"
#include "properties/attack/job_pool.hpp"
#include "properties/attack/twins.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Ends a job of a pool that is told to stop; seen by nobody.
struct Stopped {};

std::string part_of(const PowerTarget& target) {
  const Claim& claim = target.claim;
  const std::string conclusion = claim.conclusions[target.conclusion].name;
  if (!target.place.is_hypothesis) return conclusion;
  return claim.hypotheses[target.place.part].name + " → " + conclusion;
}

std::string scale_cell(const PowerTarget& target, const Power& power) {
  if (!power.has_instance) return "no instance";
  if (target.place.place.kind == PlaceKind::factor) return "–";
  if (!power.scale) return "no power";
  return *power.scale == Rational(1) ? "REFUTED" : scale_text(*power.scale);
}

std::string deletion_cell(const Power& power) {
  if (!power.has_instance || !power.can_be_deleted) return "–";
  if (power.is_deletion_refuted) return "refuted";
  return power.is_weaker ? "says less" : "no power";
}

bool has_power(const Power& power) { return power.scale || power.is_deletion_refuted; }

std::string in_cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c == '\n' ? ' ' : c);
  return result;
}

void print_table(const std::vector<PowerTarget>& targets, const std::vector<Power>& results) {
  std::cout
      << "| claim / part | shape | place | kind | refuted when scaled | when deleted |\n|---|---|---|---|--:|---|\n";
  for (std::size_t at = 0; at < targets.size(); ++at) {
    const Place& place = targets[at].place.place;
    std::cout << fmt::format("| {} / {} | {} | `{}` | {} | {} | {} |\n", targets[at].claim.name, part_of(targets[at]),
                             text_of(targets[at].shape), in_cell(place.text), name_of(place.kind),
                             scale_cell(targets[at], results[at]), deletion_cell(results[at]));
  }
}

void print_json(const std::vector<PowerTarget>& targets, const std::vector<Power>& results) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t at = 0; at < targets.size(); ++at) {
    const PowerTarget& target = targets[at];
    const Power& power = results[at];
    nlohmann::ordered_json one{{"claim", target.claim.name},
                               {"conclusion", target.claim.conclusions[target.conclusion].name}};
    if (target.place.is_hypothesis) one["hypothesis"] = target.claim.hypotheses[target.place.part].name;
    one["k"] = target.shape.k;
    one["m"] = target.shape.m;
    one["place"] = target.place.place.text;
    one["kind"] = name_of(target.place.place.kind);
    if (power.scale) one["scale"] = exact_text(*power.scale);
    if (power.can_be_deleted) one["deletion_refuted"] = power.is_deletion_refuted;
    if (power.is_weaker) one["says_less"] = true;
    one["power"] = has_power(power);
    if (!power.has_instance) one["instance"] = false;
    one["evaluations"] = power.evaluations;
    if (power.witness) one["refuted"] = power.changed;
    list.push_back(std::move(one));
  }
  std::cout << list.dump(1) << "\n";
}

std::string witness_name(const PowerTarget& target, std::size_t number) {
  return fmt::format("{}.{}.{}-{}.place-{}.json", target.claim.name, target.claim.conclusions[target.conclusion].name,
                     target.shape.k, target.shape.m, number);
}

std::vector<PowerTarget> targets_of(const SearchOptions& options) {
  std::vector<PowerTarget> result;
  for (const Claim& claim : claims_about_instances(options.claims)) {
    const auto places = power_places(claim);
    for (const Shape& shape : shapes_of(options.claims, claim)) {
      const std::uint64_t evaluations = evaluations_of(options, claim, shape);
      for (const PowerPlace& place : places) {
        if (!place.is_hypothesis) {
          result.push_back({claim, place, place.part, shape, evaluations});
          continue;
        }
        for (std::size_t at = 0; at < claim.conclusions.size(); ++at) {
          result.push_back({claim, place, at, shape, evaluations});
        }
      }
    }
  }
  if (result.empty()) throw InputError("no claim with a number that could be moved is about a class with this --shape");
  return result;
}

std::vector<Power> searched(const std::vector<PowerTarget>& targets, const SearchOptions& options,
                            const Progress& progress) {
  // The claims' functions live in it: made before the threads ask for it.
  (void)full_vocabulary();
  std::vector<Power> results(targets.size());
  std::atomic<std::size_t> done = 0;
  const Job job = [&](std::size_t at, const std::atomic<bool>& stopping) {
    results[at] = power_of(targets[at], options.seed, [&stopping](std::string_view, std::size_t, std::size_t) {
      if (stopping) throw Stopped();
    });
    ++done;
  };
  run_jobs(targets.size(), threads_of(options), job, [&] { progress("power", done, targets.size()); });
  return results;
}

ExitStatus run_power(const SearchOptions& options) {
  require_evaluations(options);
  const std::vector<PowerTarget> targets = targets_of(options);
  std::vector<Power> results;
  {
    const InterruptionDeadline deadline;
    ProgressLine line;
    results = searched(targets, options, line.callback());
  }
  ExitStatus status = ExitStatus::verified;
  for (std::size_t at = 0; at < results.size(); ++at) {
    if (!options.witnesses.empty() && results[at].witness) {
      write_witness(options, witness_name(targets[at], at + 1),
                    witness_of(targets[at].claim, targets[at].conclusion, *results[at].witness));
    }
    if (results[at].scale == Rational(1)) status = ExitStatus::rejected;
    if (!has_power(results[at]) && !results[at].is_weaker && status == ExitStatus::verified) {
      status = ExitStatus::undecided;
    }
  }
  options.json ? print_json(targets, results) : print_table(targets, results);
  return status;
}

}  // namespace

void add_power(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<SearchOptions>(2000);
  CLI::App* command = add_named(program, about_power);
  add_search_options(*command, *options, "place", "the instances that refute the changed claims");
  command->footer(
      "A place is a bound, a term of a sum, a constant within, or a factor. It is scaled by steps of 1/64 of a power "
      "of\n"
      "two, and deleted. The scale nearest to 1 is printed with which an instance refutes the changed claim, decided\n"
      "exactly; \"no power\" if none was found. Exit status 2 if a place has no power, 1 if the claim itself is "
      "refuted.\n\n"
      "Examples:\n"
      "  delcert power circumradius-under-distortion --shape 2,2\n"
      "  delcert power raw-hoop-distortion --evaluations 100000 --witnesses moved");
  command->callback([options, &chosen] { chosen = [options] { return run_power(*options); }; });
}

}  // namespace delcert
