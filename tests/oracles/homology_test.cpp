// Betti numbers over 𝔽₂ of certified complexes of tori, by GUDHI.

#include "kernel/topology/homology.hpp"

#include "tests/oracles/certified_run.hpp"
#include "tests/oracles/gudhi_homology.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// β₀ … β_m over 𝔽₂ of the complex of all faces, a face being its set of labels, and its Euler characteristic.
template <int m>
std::pair<std::vector<int>, long> homology_of(const std::vector<LiftedSimplex<m>>& simplices) {
  std::vector<std::uint32_t> labels;
  for (const LiftedSimplex<m>& simplex : simplices) {
    for (const Lift<m>& lift : simplex) labels.push_back(lift.index);
  }
  return gudhi_homology(m, labels, 2);
}

template <int m>
void expect_torus(const std::string& manifold, RunMode mode, const std::vector<int>& betti,
                  const std::vector<int>& betti_of_punctured) {
  const auto run = certified_run<m>(manifold, 24, mode);
  const auto [found, euler] = homology_of<m>(run.simplices());
  EXPECT_EQ(found, betti);
  EXPECT_EQ(euler, 0);
  EXPECT_EQ(run.result.complex.euler_characteristic(), euler);
  std::vector<AbelianGroup> over_integers;
  for (const int rank : betti) over_integers.push_back({static_cast<std::size_t>(rank), {}});
  EXPECT_EQ(homology(run.result.complex.label_complex()), over_integers);

  auto punctured = run.simplices();
  punctured.pop_back();
  EXPECT_EQ(homology_of<m>(punctured).first, betti_of_punctured);
}

TEST(Homology, square_torus) { expect_torus<2>("torus-2", RunMode::theory, {1, 2, 1}, {1, 2, 0}); }
TEST(Homology, hexagonal_torus) { expect_torus<2>("torus-2-hexagonal", RunMode::measured, {1, 2, 1}, {1, 2, 0}); }
TEST(Homology, cubic_torus) { expect_torus<3>("torus-3", RunMode::theory, {1, 3, 3, 1}, {1, 3, 3, 0}); }

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
