#include "properties/attack/tally.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

#include "properties/attack/attempt.hpp"
#include "properties/attack/hypothesis_limits.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

std::string hexadecimal(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%a", value);
  return text.data();
}

std::uint32_t stream(const Claim& claim, const Shape& shape) {
  return stream_of(claim.name + " " + std::to_string(shape.k) + " " + std::to_string(shape.m));
}

bool is_worse(const DoubleBounds& a, const std::optional<DoubleBounds>& b) {
  return !std::isnan(a.lower) && !std::isnan(a.upper) && (!b || a.lower > b->lower);
}

/// Throws for what `hexadecimal` does not write.
double from_hexadecimal(const Json& json) {
  const auto text = json.get<std::string>();
  char* end = nullptr;
  const double result = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || std::isnan(result)) throw InputError(text + " is not a bound of a ratio");
  return result;
}

void record(ConclusionTally& tally, const ConclusionOutcome& outcome, std::uint64_t number) {
  if (is_proved(outcome.verdict)) ++tally.held;
  if (is_undecided(outcome.verdict)) ++tally.undecided;
  if (is_refuted(outcome.verdict) && ++tally.violated == 1) tally.first_violation = number;
  if (outcome.ratio && is_worse(*outcome.ratio, tally.worst)) {
    tally.worst = outcome.ratio;
    tally.worst_sample = number;
  }
}

void record(Tally& tally, const Claim& claim, const std::optional<Instance>& instance, std::uint64_t number) {
  ++tally.samples;
  if (!instance) {
    ++tally.not_drawn;
    return;
  }
  // A ratio that is not above the worst so far need not be known sharply.
  std::vector<double> known;
  for (const ConclusionTally& conclusion : tally.conclusions) {
    known.push_back(conclusion.worst ? conclusion.worst->lower : -std::numeric_limits<double>::infinity());
  }
  const LadderStatistics before = ladder_statistics();
  const Attempt result = attempt(claim, instance->bindings, known);
  tally.rungs += ladder_statistics() - before;
  if (is_refuted(result.hypotheses)) {
    ++tally.hypotheses_not_met;
    return;
  }
  if (is_undecided(result.hypotheses)) {
    ++tally.hypotheses_undecided;
    return;
  }
  for (const Trait trait : instance->traits) ++tally.traits[static_cast<std::size_t>(trait)];
  ++tally.manifolds[instance_class(claim.instance).manifold(instance->bindings)];
  for (std::size_t at = 0; at < result.conclusions.size(); ++at) {
    record(tally.conclusions[at], result.conclusions[at], number);
  }
}

}  // namespace

std::uint64_t Tally::undecided() const {
  std::uint64_t result = hypotheses_undecided;
  for (const ConclusionTally& conclusion : conclusions) result += conclusion.undecided;
  return result;
}

bool Tally::is_refuted() const {
  for (const ConclusionTally& conclusion : conclusions) {
    if (conclusion.violated > 0) return true;
  }
  return false;
}

void Tally::add(const Tally& later) {
  samples += later.samples;
  not_drawn += later.not_drawn;
  hypotheses_not_met += later.hypotheses_not_met;
  hypotheses_undecided += later.hypotheses_undecided;
  for (std::size_t trait = 0; trait < traits.size(); ++trait) traits[trait] += later.traits[trait];
  for (const auto& [name, count] : later.manifolds) manifolds[name] += count;
  rungs += later.rungs;
  conclusions.resize(std::max(conclusions.size(), later.conclusions.size()));
  for (std::size_t at = 0; at < later.conclusions.size(); ++at) {
    ConclusionTally& mine = conclusions[at];
    const ConclusionTally& other = later.conclusions[at];
    if (mine.violated == 0) mine.first_violation = other.first_violation;
    mine.held += other.held;
    mine.violated += other.violated;
    mine.undecided += other.undecided;
    if (other.worst && is_worse(*other.worst, mine.worst)) {
      mine.worst = other.worst;
      mine.worst_sample = other.worst_sample;
    }
  }
}

Json tally_json(const Tally& tally) {
  Json result;
  result["samples"] = tally.samples;
  result["not_drawn"] = tally.not_drawn;
  result["hypotheses_not_met"] = tally.hypotheses_not_met;
  result["hypotheses_undecided"] = tally.hypotheses_undecided;
  result["traits"] = tally.traits;
  result["manifolds"] = tally.manifolds;
  result["rungs"] = tally.rungs.settled;
  result["rungs_undecided"] = tally.rungs.undecided;
  result["conclusions"] = Json::array();
  for (const ConclusionTally& conclusion : tally.conclusions) {
    Json one;
    one["held"] = conclusion.held;
    one["violated"] = conclusion.violated;
    one["undecided"] = conclusion.undecided;
    if (conclusion.worst) {
      one["worst"] = {hexadecimal(conclusion.worst->lower), hexadecimal(conclusion.worst->upper)};
      one["worst_sample"] = conclusion.worst_sample;
    }
    if (conclusion.violated > 0) one["first_violation"] = conclusion.first_violation;
    result["conclusions"].push_back(std::move(one));
  }
  return result;
}

Tally tally_from(const Json& json) {
  Tally result;
  json.at("samples").get_to(result.samples);
  json.at("not_drawn").get_to(result.not_drawn);
  json.at("hypotheses_not_met").get_to(result.hypotheses_not_met);
  json.at("hypotheses_undecided").get_to(result.hypotheses_undecided);
  json.at("traits").get_to(result.traits);
  json.at("manifolds").get_to(result.manifolds);
  json.at("rungs").get_to(result.rungs.settled);
  json.at("rungs_undecided").get_to(result.rungs.undecided);
  for (const Json& one : json.at("conclusions")) {
    ConclusionTally conclusion;
    one.at("held").get_to(conclusion.held);
    one.at("violated").get_to(conclusion.violated);
    one.at("undecided").get_to(conclusion.undecided);
    if (one.contains("worst")) {
      conclusion.worst = DoubleBounds{from_hexadecimal(one.at("worst").at(0)), from_hexadecimal(one.at("worst").at(1))};
      one.at("worst_sample").get_to(conclusion.worst_sample);
    }
    if (conclusion.violated > 0) one.at("first_violation").get_to(conclusion.first_violation);
    result.conclusions.push_back(conclusion);
  }
  return result;
}

std::optional<Instance> sample_instance(const Claim& claim, const Shape& shape, std::uint64_t seed,
                                        std::uint64_t number) {
  RandomChoices choices(seed, stream(claim, shape), number);
  return draw_instance(claim, HypothesisLimits(claim), shape, choices);
}

Tally attack_block(const Claim& claim, const Shape& shape, std::uint64_t seed, std::uint64_t first,
                   std::uint64_t count) {
  const HypothesisLimits limits(claim);
  Tally tally;
  tally.conclusions.resize(claim.conclusions.size());
  const std::uint32_t its_stream = stream(claim, shape);
  for (std::uint64_t number = first; number < first + count; ++number) {
    RandomChoices choices(seed, its_stream, number);
    record(tally, claim, draw_instance(claim, limits, shape, choices), number);
  }
  return tally;
}

}  // namespace delcert
