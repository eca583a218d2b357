// The stages of a run, one benchmark each, on the same nets. Built twice: with the real kernel, and with plain doubles
// in place of the filter (then nothing is certified). CGAL's periodic Delaunay triangulation of the perturbed points
// stands beside them.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/flat_space.hpp"
#include "kernel/perturb/forbidden_search.hpp"
#include "kernel/run/run.hpp"
#include "kernel/sample/net_measure.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/sample/separation.hpp"
#include "proofs/certificate/run_parameters.hpp"

namespace delcert {
namespace {

using DoubleKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

template <int m>
struct CgalPeriodic;
template <>
struct CgalPeriodic<2> {
  using Triangulation =
      CGAL::Periodic_2_Delaunay_triangulation_2<CGAL::Periodic_2_Delaunay_triangulation_traits_2<DoubleKernel>>;
  static DoubleKernel::Point_2 point(const Vector<double, 2>& x) { return {x[0], x[1]}; }
};
template <>
struct CgalPeriodic<3> {
  using Triangulation =
      CGAL::Periodic_3_Delaunay_triangulation_3<CGAL::Periodic_3_Delaunay_triangulation_traits_3<DoubleKernel>>;
  static DoubleKernel::Point_3 point(const Vector<double, 3>& x) { return {x[0], x[1], x[2]}; }
};

/// One net on a cubic torus, with what each stage leaves for the next. Made on demand, outside of what is timed.
template <int m>
class Scene {
 public:
  explicit Scene(int n)
      : radius_(Integer(1), Integer(n)),
        space_(flat_space_of<m>(find_manifold("torus-" + std::to_string(m)))),
        net_(sample()),
        atlas_(space_, net_, density().sampling_radius),
        parameters_(parameters_for(Dimension(m), measure_separation<m>(atlas_), {})) {}

  std::vector<Vector<Rational, m>> sample() const { return poisson_disk_net<m>(space_, radius_, 0, no_progress()); }
  NetDensity<m> density() const { return measure_density<m>(space_, net_, radius_, no_progress()); }
  std::size_t size() const { return net_.size(); }

  PointSet<m> perturb() const {
    Perturbation<m> perturbation(atlas_, parameters_.algorithm);
    perturbation.place_all(no_progress());
    return perturbation.points();
  }
  const PointSet<m>& perturbed() {
    if (!perturbed_) perturbed_ = perturb();
    return *perturbed_;
  }

  StarComplex<m> triangulate(const PointSet<m>& points) const {
    return StarComplex<m>(
        propose_delaunay<m>(space_, points.approximate_all(), approximate_double(atlas_.sampling_radius())),
        std::vector<bool>(size(), true));
  }
  const StarComplex<m>& complex() {
    if (!complex_) complex_ = triangulate(perturbed());
    return *complex_;
  }
  bool certify_stars(const PointSet<m>& points, const StarComplex<m>& complex) const {
    return certify_protection<m>(atlas_, points, complex, std::nullopt, no_progress()).margins.has_value() &&
           complex.combinatorial_failures().empty();
  }

  ForbiddenSearch search(const PointSet<m>& points) const {
    return search_forbidden<m>(atlas_, points, parameters_.forbidden(atlas_.sampling_radius()),
                               parameters_.algorithm.perturbation * atlas_.sampling_radius(), no_progress());
  }

  auto points_for_cgal() {
    std::vector<decltype(CgalPeriodic<m>::point({}))> result;
    for (Vector<double, m> x : perturbed().approximate_all()) {
      for (double& coordinate : x) {
        coordinate -= std::floor(coordinate);
        if (coordinate >= 1) coordinate = 0;
      }
      result.push_back(CgalPeriodic<m>::point(x));
    }
    return result;
  }

 private:
  Rational radius_;
  FlatSpace<m> space_;
  PointSet<m> net_;
  FlatAtlas<m> atlas_;
  RunParameters parameters_;
  std::optional<PointSet<m>> perturbed_;
  std::optional<StarComplex<m>> complex_;
};

/// Kept, since a benchmark is entered several times.
template <int m>
Scene<m>& scene(int n) {
  static std::map<int, std::unique_ptr<Scene<m>>> scenes;
  auto& result = scenes[n];
  if (!result) result = std::make_unique<Scene<m>>(n);
  return *result;
}

template <int m>
void sample(benchmark::State& state, int n) {
  const auto& at = scene<m>(n);
  for (auto _ : state) benchmark::DoNotOptimize(at.sample());
  state.counters["points"] = static_cast<double>(at.size());
}

template <int m>
void measure_density_of_net(benchmark::State& state, int n) {
  const auto& at = scene<m>(n);
  for (auto _ : state) benchmark::DoNotOptimize(at.density());
}

template <int m>
void perturb(benchmark::State& state, int n) {
  const auto& at = scene<m>(n);
  for (auto _ : state) benchmark::DoNotOptimize(at.perturb());
}

template <int m>
void triangulate(benchmark::State& state, int n) {
  auto& at = scene<m>(n);
  const auto& points = at.perturbed();
  for (auto _ : state) benchmark::DoNotOptimize(at.triangulate(points));
}

template <int m>
void certify_stars(benchmark::State& state, int n) {
  auto& at = scene<m>(n);
  const auto& complex = at.complex();
  for (auto _ : state) {
    if (!at.certify_stars(at.perturbed(), complex)) state.SkipWithError("a star is not certified");
  }
}

template <int m>
void search_for_forbidden(benchmark::State& state, int n) {
  auto& at = scene<m>(n);
  const auto& points = at.perturbed();
  for (auto _ : state) {
    const ForbiddenSearch search = at.search(points);
    if (search.found) state.SkipWithError("the search ends early, at a forbidden configuration");
    state.counters["configurations"] = static_cast<double>(search.configurations);
  }
}

template <int m>
void cgal_periodic_delaunay(benchmark::State& state, int n) {
  const auto points = scene<m>(n).points_for_cgal();
  for (auto _ : state) {
    typename CgalPeriodic<m>::Triangulation triangulation;
    triangulation.insert(points.begin(), points.end(), true);
    benchmark::DoNotOptimize(triangulation.number_of_vertices());
  }
}

template <int m>
void add(int n) {
  const std::string net = "torus-" + std::to_string(m) + ":1_" + std::to_string(n) + "/";
  const auto add_one = [&](const char* stage, void (*function)(benchmark::State&, int)) {
    benchmark::RegisterBenchmark((net + stage).c_str(), function, n)->Unit(benchmark::kMillisecond);
  };
  add_one("sample", sample<m>);
  add_one("measure_density", measure_density_of_net<m>);
  add_one("perturb", perturb<m>);
  add_one("triangulate", triangulate<m>);
  add_one("certify_stars", certify_stars<m>);
  add_one("search_forbidden", search_for_forbidden<m>);
  add_one("cgal_periodic_delaunay", cgal_periodic_delaunay<m>);
}

}  // namespace
}  // namespace delcert

int main(int argc, char** argv) {
  benchmark::AddCustomContext("kernel", delcert::filter_is_rigorous ? "certified" : "plain doubles");
  delcert::add<2>(24);
  delcert::add<2>(100);
  delcert::add<3>(24);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
