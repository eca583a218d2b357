// What it costs to decide lemmas on instances as attacks draw them, thin and special ones among them: by the ladder, by
// 256-bit intervals only, and, of the conclusions that a program of rationals can decide, in plain rationals only; and
// what a whole sample of an attack costs, with drawing the instance and enclosing the ratios.

#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/simplex/altitude.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/singular_values.hpp"
#include "kernel/simplex/thickness.hpp"
#include "proofs/formula/simplex_object.hpp"
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

/// Rational numbers as a program without a ladder has them: every operation in fractions.
class Fraction {
 public:
  Fraction(int integer) : value_(integer) {}
  explicit Fraction(Rational value) : value_(std::move(value)) {}

  friend Fraction operator+(const Fraction& a, const Fraction& b) { return Fraction(a.value_ + b.value_); }
  friend Fraction operator-(const Fraction& a, const Fraction& b) { return Fraction(a.value_ - b.value_); }
  friend Fraction operator*(const Fraction& a, const Fraction& b) { return Fraction(a.value_ * b.value_); }
  friend Fraction operator/(const Fraction& a, const Fraction& b) { return Fraction(a.value_ / b.value_); }
  friend Fraction square(const Fraction& a) { return a * a; }
  friend Fraction minimum(const Fraction& a, const Fraction& b) { return Fraction(minimum(a.value_, b.value_)); }
  friend Fraction maximum(const Fraction& a, const Fraction& b) { return Fraction(maximum(a.value_, b.value_)); }
  friend Verdict less(const Fraction& a, const Fraction& b) { return less(a.value_, b.value_); }
  friend Verdict less_equal(const Fraction& a, const Fraction& b) { return less_equal(a.value_, b.value_); }
  friend Verdict is_zero(const Fraction& a) { return is_zero(a.value_); }

 private:
  Rational value_;
};

/// In fractions, or, for Q = Rational, in integers over a common denominator, as all of the elimination is then.
template <class Q>
EdgeGram<Q> gram_in(const SimplexObject& simplex) {
  std::vector<std::vector<Q>> points;
  for (const auto& point : simplex.points()) points.emplace_back(point.begin(), point.end());
  return edge_gram_from_points(points);
}

/// What a program of rationals only would do, on squares: s_k(P)² ≥ kΥ²Δ².
template <class Q>
Verdict singular_value_in_rationals(const SimplexObject& simplex) {
  const EdgeGram<Q> gram = gram_in<Q>(simplex);
  const Q k(static_cast<int>(simplex.dimension()));
  const Partial<Q> thickness = squared_thickness(gram);
  if (!thickness) return Verdict::undecided;
  return is_smallest_singular_value_at_least(gram, Q(k * *thickness * squared_longest_edge(gram)));
}

/// R² ≤ Δ²/(4Υ²).
template <class Q>
Verdict crude_radius_in_rationals(const SimplexObject& simplex) {
  const EdgeGram<Q> gram = gram_in<Q>(simplex);
  const Partial<Q> thickness = squared_thickness(gram);
  const Partial<Q> radius = squared_circumradius(gram);
  if (!thickness || !radius) return Verdict::undecided;
  return less_equal(Q(Q(4) * *radius * *thickness), squared_longest_edge(gram));
}

template <class Decide>
void in_rationals(benchmark::State& state, const std::vector<Bindings>& instances, const Decide& decide) {
  for (auto _ : state) {
    for (const Bindings& bindings : instances) {
      benchmark::DoNotOptimize(decide(object_of<SimplexObject>(std::get<ObjectPointer>(bindings.at("s")))));
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

std::string prefix_of(const std::string& name, const Shape& shape) {
  return name + "/k=" + std::to_string(shape.k) + ",m=" + std::to_string(shape.m) + "/";
}

void whole_samples(benchmark::State& state, const Claim& claim, const Shape& shape) {
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

/// One conclusion on each of three ways, that in rationals twice: in fractions and without.
template <class Decide, class DecideInIntegers>
void add_rational(const std::string& name, const std::string& conclusion, const Shape& shape, const Decide& decide,
                  const DecideInIntegers& decide_in_integers) {
  const std::string prefix = prefix_of(name + ":" + conclusion, shape);
  benchmark::RegisterBenchmark((prefix + "ladder").c_str(), [=](benchmark::State& state) {
    const Subject& one = subject(name, shape, conclusion);
    by_ladder(state, one.claim, one.instances);
  });
  benchmark::RegisterBenchmark((prefix + "256_bits").c_str(), [=](benchmark::State& state) {
    const Subject& one = subject(name, shape, conclusion);
    on_one_rung<BigInterval>(state, one.claim, one.instances);
  });
  benchmark::RegisterBenchmark((prefix + "rationals").c_str(), [=](benchmark::State& state) {
    in_rationals(state, subject(name, shape, conclusion).instances, decide);
  });
  benchmark::RegisterBenchmark((prefix + "fraction_free").c_str(), [=](benchmark::State& state) {
    in_rationals(state, subject(name, shape, conclusion).instances, decide_in_integers);
  });
}

}  // namespace
}  // namespace delcert

int main(int argc, char** argv) {
  using namespace delcert;
  for (const Shape& shape : {Shape{2, 2}, Shape{3, 3}, Shape{6, 6}}) {
    add("thickness-and-singular-value", shape);
    add_rational("thickness-and-singular-value", "smallest-singular-value", shape,
                 singular_value_in_rationals<Fraction>, singular_value_in_rationals<Rational>);
    add("crude-circumradius-bound", shape);
    add_rational("crude-circumradius-bound", "circumradius", shape, crude_radius_in_rationals<Fraction>,
                 crude_radius_in_rationals<Rational>);
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
