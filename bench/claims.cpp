// What it costs to decide lemmas on instances as attacks draw them, thin and special ones among them: by the ladder and
// by 256-bit intervals only; what a whole sample of an attack costs, with drawing the instance and enclosing the
// ratios; and what the same costs, without drawing, in rational numbers only.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/attack_in_rationals.hpp"
#include "kernel/number/recycled_limbs.hpp"
#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/tally.hpp"

namespace delcert {
namespace {

constexpr std::uint64_t instance_count = 256;
constexpr std::uint64_t seed = 1;

/// The instances that an attack on a claim in this shape begins with.
std::vector<Bindings> drawn_instances(const Claim& claim, const Shape& shape) {
  std::vector<Bindings> result;
  for (std::uint64_t number = 0; result.size() < instance_count; ++number) {
    auto instance = sample_instance(claim, shape, seed, number);
    if (instance) result.push_back(std::move(instance->bindings));
  }
  return result;
}

void finish(benchmark::State& state) {
  const std::int64_t decisions = state.iterations() * static_cast<std::int64_t>(instance_count);
  state.SetItemsProcessed(decisions);
  state.counters["each"] =
      benchmark::Counter(static_cast<double>(decisions), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void by_ladder(benchmark::State& state, const Claim& claim, const std::vector<Bindings>& instances) {
  const RecycledLimbs recycled;
  const LadderStatistics before = ladder_statistics();
  for (auto _ : state) {
    for (const Bindings& bindings : instances) {
      Scene scene(bindings);
      for (const Hypothesis& hypothesis : claim.hypotheses) {
        benchmark::DoNotOptimize(decide_statement(*hypothesis.formula, scene));
      }
      for (const Conclusion& conclusion : claim.conclusions) {
        benchmark::DoNotOptimize(decide_statement(*conclusion.formula, scene));
      }
    }
  }
  const LadderStatistics rungs = ladder_statistics() - before;
  state.counters["filter"] = static_cast<double>(rungs.settled[0]) / static_cast<double>(rungs.total());
  finish(state);
}

template <class S>
void on_one_rung(benchmark::State& state, const Claim& claim, const std::vector<Bindings>& instances) {
  const BigInterval::Precision precision(PrecisionBits{256});
  for (auto _ : state) {
    for (const Bindings& bindings : instances) {
      Scene scene(bindings);
      for (const Hypothesis& hypothesis : claim.hypotheses) {
        benchmark::DoNotOptimize(Evaluation<S>(scene).truth(*hypothesis.formula));
      }
      for (const Conclusion& conclusion : claim.conclusions) {
        benchmark::DoNotOptimize(Evaluation<S>(scene).truth(*conclusion.formula));
      }
    }
  }
  finish(state);
}

/// The claim with this conclusion only.
Claim with_conclusion(Claim claim, const std::string& name) {
  std::erase_if(claim.conclusions, [&](const Conclusion& conclusion) { return conclusion.name != name; });
  if (claim.conclusions.empty()) throw std::invalid_argument(claim.name + " has no conclusion " + name);
  return claim;
}

struct Subject {
  Claim claim;
  std::vector<Bindings> instances;
};

/// All conclusions of a claim, or one of them.
const Subject& subject(const std::string& name, const Shape& shape, const std::string& conclusion = {}) {
  static std::map<std::string, std::unique_ptr<Subject>> subjects;
  auto& result = subjects[name + "/" + conclusion + std::to_string(shape.k) + "," + std::to_string(shape.m)];
  if (!result) {
    const Claim claim = find_claim(name);
    result = std::make_unique<Subject>(
        Subject{conclusion.empty() ? claim : with_conclusion(claim, conclusion), drawn_instances(claim, shape)});
  }
  return *result;
}

/// Throws unless the peer says of these instances what an attack says, so that both are measured at the same work.
template <class Peer>
void require_agreement(const Claim& claim, const std::vector<Bindings>& instances) {
  Peer peer;
  std::vector<std::uint64_t> held(claim.conclusions.size());
  std::vector<double> worst(claim.conclusions.size());
  for (const Bindings& bindings : instances) {
    peer.decide(object_of<SimplexObject>(std::get<ObjectPointer>(bindings.at("s"))));
    const Attempt attempted = attempt(claim, bindings);
    for (std::size_t at = 0; at < attempted.conclusions.size(); ++at) {
      const ConclusionOutcome& outcome = attempted.conclusions[at];
      if (is_proved(outcome.verdict)) ++held[at];
      if (outcome.ratio) worst[at] = std::max(worst[at], outcome.ratio->lower);
    }
  }
  const auto conclusions = peer.conclusions();
  for (std::size_t at = 0; at < held.size(); ++at) {
    const auto& tally = conclusions[at];
    const double ratio = tally.worst_squared ? std::sqrt(approximately(*tally.worst_squared)) : worst[at];
    if (tally.held != held[at] || std::abs(ratio - worst[at]) > 0x1p-18 * worst[at]) {
      throw std::logic_error(claim.name + ", " + claim.conclusions[at].name + ": rationals do not agree");
    }
  }
}

/// A block of samples without drawing: `Peer` decides and measures the same.
template <class Peer>
void in_rationals(benchmark::State& state, const Subject& subject) {
  const std::vector<Bindings>& instances = subject.instances;
  require_agreement<Peer>(subject.claim, instances);
  for (auto _ : state) {
    Peer peer;
    for (const Bindings& bindings : instances) {
      peer.decide(object_of<SimplexObject>(std::get<ObjectPointer>(bindings.at("s"))));
    }
    benchmark::DoNotOptimize(peer);
  }
  finish(state);
}

std::string prefix_of(const std::string& name, const Shape& shape) {
  return name + "/k=" + std::to_string(shape.k) + ",m=" + std::to_string(shape.m) + "/";
}

void whole_samples(benchmark::State& state, const Claim& claim, const Shape& shape) {
  const RecycledLimbs recycled;
  for (auto _ : state) benchmark::DoNotOptimize(attack_block(claim, shape, seed, 0, instance_count));
  finish(state);
}

/// What an attack does.
void add(const std::string& name, const Shape& shape) {
  const std::string prefix = prefix_of(name, shape);
  benchmark::RegisterBenchmark((prefix + "sample").c_str(), [=](benchmark::State& state) {
    whole_samples(state, subject(name, shape).claim, shape);
  });
  benchmark::RegisterBenchmark((prefix + "ladder").c_str(), [=](benchmark::State& state) {
    by_ladder(state, subject(name, shape).claim, subject(name, shape).instances);
  });
}

/// One conclusion by the ladder and by 256 bits.
void add_conclusion(const std::string& name, const std::string& conclusion, const Shape& shape) {
  const std::string prefix = prefix_of(name + ":" + conclusion, shape);
  benchmark::RegisterBenchmark((prefix + "ladder").c_str(), [=](benchmark::State& state) {
    const Subject& one = subject(name, shape, conclusion);
    by_ladder(state, one.claim, one.instances);
  });
  benchmark::RegisterBenchmark((prefix + "256_bits").c_str(), [=](benchmark::State& state) {
    const Subject& one = subject(name, shape, conclusion);
    on_one_rung<BigInterval>(state, one.claim, one.instances);
  });
}

/// All that a sample decides and measures, in fractions and without.
template <template <class> class Peer>
void add_rational(const std::string& name, const Shape& shape) {
  const std::string prefix = prefix_of(name, shape);
  benchmark::RegisterBenchmark((prefix + "rationals").c_str(), [=](benchmark::State& state) {
    in_rationals<Peer<Fraction>>(state, subject(name, shape));
  });
  benchmark::RegisterBenchmark((prefix + "fraction_free").c_str(), [=](benchmark::State& state) {
    in_rationals<Peer<Rational>>(state, subject(name, shape));
  });
}

}  // namespace
}  // namespace delcert

int main(int argc, char** argv) {
  using namespace delcert;
  for (const Shape& shape : {Shape{2, 2}, Shape{3, 3}, Shape{6, 6}}) {
    add("thickness-and-singular-value", shape);
    add_conclusion("thickness-and-singular-value", "smallest-singular-value", shape);
    add_rational<SingularValueInRationals>("thickness-and-singular-value", shape);
    add("crude-circumradius-bound", shape);
    add_conclusion("crude-circumradius-bound", "circumradius", shape);
    add_rational<CrudeRadiusInRationals>("crude-circumradius-bound", shape);
  }
  for (const Claim& claim : builtin_claim_list()) {
    const bool is_simplex = claim.instance == "simplex";
    const bool is_costly = instance_class(claim.instance).cost({0, 2}) > 1;
    if (!is_simplex && !is_costly) add(claim.name, {3, 3});
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
