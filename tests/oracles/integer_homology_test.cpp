// Homology over the integers against Betti numbers over 𝔽₂, 𝔽₃ and 𝔽₅ by GUDHI.

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/topology/homology.hpp"
#include "tests/kernel/topology/known_complexes.hpp"
#include "tests/oracles/gudhi_homology.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// dim H_k(K; 𝔽_p) by the universal coefficient theorem.
std::vector<int> betti_numbers(const std::vector<AbelianGroup>& groups, int p) {
  std::vector<int> result;
  std::ptrdiff_t divisible_below = 0;
  for (const AbelianGroup& group : groups) {
    const auto divisible =
        std::count_if(group.torsion.begin(), group.torsion.end(), [p](const Integer& order) { return order % p == 0; });
    result.push_back(static_cast<int>(static_cast<std::ptrdiff_t>(group.free_rank) + divisible + divisible_below));
    divisible_below = divisible;
  }
  return result;
}

std::vector<AbelianGroup> homology_of(const LabelComplex& complex) {
  return homology(PureComplex(Dimension(complex.dimension), complex.labels));
}

TEST(IntegerHomology, has_the_betti_numbers_of_gudhi) {
  for (const KnownComplex& known : known_complexes()) {
    const auto groups = homology_of(known.complex);
    for (const int p : {2, 3, 5}) {
      const auto [betti, euler] = gudhi_homology(known.complex.dimension, known.complex.labels, p);
      EXPECT_EQ(betti_numbers(groups, p), betti) << known.name << " over " << p;
      EXPECT_EQ(PureComplex(Dimension(known.complex.dimension), known.complex.labels).euler_characteristic(), euler);
    }
  }
}

TEST(IntegerHomology, of_a_punctured_manifold_has_them_too) {
  for (const KnownComplex& known : known_complexes()) {
    if (!known.closed_manifold) continue;
    const LabelComplex punctured = without_simplex(known.complex, known.complex.size() / 2);
    const auto groups = homology_of(punctured);
    EXPECT_NE(groups, homology_of(known.complex)) << known.name;
    for (const int p : {2, 3}) {
      EXPECT_EQ(betti_numbers(groups, p), gudhi_homology(punctured.dimension, punctured.labels, p).first) << known.name;
    }
  }
}

TEST(IntegerHomology, is_told_apart_by_the_fields) {
  const LabelComplex space = lens_space(5, 2);
  EXPECT_EQ(gudhi_homology(3, space.labels, 2).first, (std::vector<int>{1, 0, 0, 1}));
  EXPECT_EQ(gudhi_homology(3, space.labels, 5).first, (std::vector<int>{1, 1, 1, 1}));
  EXPECT_NE(betti_numbers(homology_of(lens_space(7, 2)), 5), gudhi_homology(3, space.labels, 5).first);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
