// Betti numbers over 𝔽₂ of certified complexes of tori, by GUDHI.

// First: GUDHI 3.7.1 uses it without including it.
#include <iostream>

// GUDHI
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include "tests/oracles/certified_run.hpp"

namespace delcert::test {
namespace {

/// β₀ … β_m over 𝔽₂ of the complex of all faces, a face being its set of labels, and its Euler characteristic.
template <int m>
std::pair<std::vector<int>, long> homology(const std::vector<LiftedSimplex<m>>& simplices) {
  Gudhi::Simplex_tree<> tree;
  for (const LiftedSimplex<m>& simplex : simplices) {
    std::vector<int> labels;
    for (const Lift<m>& lift : simplex) labels.push_back(static_cast<int>(lift.index));
    tree.insert_simplex_and_subfaces(labels, 0);
  }
  long euler = 0;
  for (const auto& simplex : tree.complex_simplex_range()) euler += tree.dimension(simplex) % 2 == 0 ? 1 : -1;
  constexpr bool top_dimension_too = true;
  Gudhi::persistent_cohomology::Persistent_cohomology<Gudhi::Simplex_tree<>, Gudhi::persistent_cohomology::Field_Zp>
      cohomology(tree, top_dimension_too);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(0);
  std::vector<int> betti;
  for (int dimension = 0; dimension <= m; ++dimension) betti.push_back(cohomology.betti_number(dimension));
  return {betti, euler};
}

template <int m>
void expect_torus(const std::string& manifold, RunMode mode, const std::vector<int>& betti,
                  const std::vector<int>& betti_of_punctured) {
  const auto run = certified_run<m>(manifold, 24, mode);
  const auto [found, euler] = homology<m>(run.simplices());
  EXPECT_EQ(found, betti);
  EXPECT_EQ(euler, 0);
  EXPECT_EQ(run.result.complex.euler_characteristic(), euler);

  auto punctured = run.simplices();
  punctured.pop_back();
  EXPECT_EQ(homology<m>(punctured).first, betti_of_punctured);
}

TEST(Homology, square_torus) { expect_torus<2>("torus-2", RunMode::theory, {1, 2, 1}, {1, 2, 0}); }
TEST(Homology, hexagonal_torus) { expect_torus<2>("torus-2-hexagonal", RunMode::measured, {1, 2, 1}, {1, 2, 0}); }
TEST(Homology, cubic_torus) { expect_torus<3>("torus-3", RunMode::theory, {1, 3, 3, 1}, {1, 3, 3, 0}); }

}  // namespace
}  // namespace delcert::test
