#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/flat_space.hpp"
#include "kernel/run/run.hpp"
#include "kernel/sample/net_measure.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/sample/separation.hpp"
#include "proofs/certificate/run_parameters.hpp"

// Certified runs for other software to look at.
namespace delcert::test {

/// What the command `certify` computes before it writes.
template <int m>
struct CertifiedRun {
  NetDensity<m> density;
  FlatAtlas<m> atlas;
  RunParameters parameters;
  RunResult<m> result;

  [[nodiscard]] const std::vector<LiftedSimplex<m>>& simplices() const { return result.complex.simplices(); }
};

/// The certified run on a Poisson-disk net of radius 1/n on a built-in manifold, with the seed 1.
template <int m>
CertifiedRun<m> certified_run(const std::string& manifold, int n, RunMode mode) {
  constexpr std::uint64_t seed = 1;
  const FlatSpace<m> space = flat_space_of<m>(find_manifold(manifold));
  const Rational radius(Integer(1), Integer(n));
  PointSet<m> net(poisson_disk_net<m>(space, radius, seed, no_progress()));
  auto density = measure_density<m>(space, net, radius, no_progress());
  FlatAtlas<m> atlas(space, std::move(net), density.sampling_radius);
  ParameterChoice choice;
  choice.mode = mode;
  choice.seed = seed;
  auto parameters = parameters_for(Dimension(m), measure_separation<m>(atlas), choice);
  auto result = run_algorithm<m>(atlas, parameters.algorithm, {}, no_progress());
  EXPECT_TRUE(result.is_certified());
  return {std::move(density), std::move(atlas), std::move(parameters), std::move(result)};
}

/// Asserts that the doubles nearest to the perturbed points have the same Delaunay complex as the points themselves, so
/// that software which takes doubles can be asked about it.
///
/// The double of a coordinate below 4 in size is within η = 2⁻⁵¹ of it. Translations by small integers and the passage
/// to Cartesian coordinates (sums with factors at most 1) round a few times more, so that no point moves by more than
/// 8η in a coordinate, and no distance changes by more than 2√m·8η ≤ 32η. By lem:del.metric.stability that changes no
/// star when 32η ≤ Υμδ/36, where every simplex is δ-protected and Υ-thick and points are at least με apart: μ₀ε/2 after
/// the perturbation, as ρ₀ ≤ μ₀/4.
template <int m>
void expect_rounding_is_harmless(const CertifiedRun<m>& run) {
  ASSERT_TRUE(run.result.protection.margins.has_value());
  const StarMargins& margins = *run.result.protection.margins;
  EXPECT_GT(margins.protection, Rational::power_of_two(-40) * run.atlas.sampling_radius());
  const Rational change_of_distances = Rational(32) * Rational::power_of_two(-51);
  const Rational separation = run.parameters.algorithm.separation / Rational(2);
  EXPECT_LE(Rational(36) * change_of_distances, margins.thickness * separation * margins.protection);
}

}  // namespace delcert::test
