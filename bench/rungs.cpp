// What one circumcentre costs on each rung of the ladder: three edge vectors in space, pushed on a SphereStack.

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "kernel/number/filter.hpp"
#include "kernel/simplex/sphere_stack.hpp"

namespace delcert {
namespace {

constexpr int dimension = 3;
constexpr std::size_t tetrahedra = 256;
using Edges = std::array<Vector<Rational, dimension>, dimension>;

/// Edge vectors with coordinates that are multiples of 2^exponent below 1 in size. Coordinates of perturbed points in
/// theory mode have about 100 binary digits.
std::vector<Edges> random_edges(long exponent) {
  std::mt19937_64 random(1);
  std::vector<Edges> result(tetrahedra);
  for (Edges& edges : result) {
    for (auto& edge : edges) {
      for (Rational& coordinate : edge) {
        const Integer digits = (Integer(random()) << 64) + Integer(random());
        coordinate = rounded_down(Rational(digits) * Rational::power_of_two(-127) - Rational(1), exponent);
      }
    }
  }
  return result;
}

template <class S>
void circumcentre(benchmark::State& state) {
  const RoundingGuard guard;  // the other rungs do not mind
  const auto metric = FrameMetric<dimension>::cartesian().on<S>();
  std::vector<std::array<Vector<S, dimension>, dimension>> inputs;
  for (const Edges& edges : random_edges(-100)) {
    auto& input = inputs.emplace_back();
    for (std::size_t edge = 0; edge < dimension; ++edge) {
      for (std::size_t axis = 0; axis < dimension; ++axis) input[edge][axis] = scalar_from<S>(edges[edge][axis]);
    }
  }
  for (auto _ : state) {
    for (const auto& input : inputs) {
      SphereStack<S, dimension> stack(metric);
      for (const auto& edge : input) {
        if (!is_proved(stack.push(edge, metric.squared_norm(edge)))) state.SkipWithError("a degenerate simplex");
      }
      benchmark::DoNotOptimize(stack.centre());
      benchmark::DoNotOptimize(stack.squared_radius());
    }
  }
  const double spheres = static_cast<double>(state.iterations()) * static_cast<double>(tetrahedra);
  state.counters["each"] = benchmark::Counter(spheres, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void circumcentre_in_double(benchmark::State& state) { circumcentre<PlainDouble>(state); }
void circumcentre_in_interval(benchmark::State& state) { circumcentre<Interval>(state); }
void circumcentre_in_128_bits(benchmark::State& state) {
  const BigInterval::Precision precision(PrecisionBits{128});
  circumcentre<BigInterval>(state);
}
void circumcentre_in_rational(benchmark::State& state) { circumcentre<Rational>(state); }

BENCHMARK(circumcentre_in_double);
BENCHMARK(circumcentre_in_interval);
BENCHMARK(circumcentre_in_128_bits);
BENCHMARK(circumcentre_in_rational);

}  // namespace
}  // namespace delcert

BENCHMARK_MAIN();
