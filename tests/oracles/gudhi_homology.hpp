#pragma once

// First: GUDHI 3.7.1 uses it without including it.
#include <iostream>

// GUDHI
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <cstdint>
#include <utility>
#include <vector>

// Betti numbers over prime fields by GUDHI.
namespace delcert::test {

/// β₀ … β_m over 𝔽_p, and the Euler characteristic, of the complex of all faces of m-simplices: m + 1 labels each.
inline std::pair<std::vector<int>, long> gudhi_homology(int m, const std::vector<std::uint32_t>& labels, int p) {
  Gudhi::Simplex_tree<> tree;
  const auto corners = static_cast<std::ptrdiff_t>(m) + 1;
  for (auto first = labels.begin(); first != labels.end(); first += corners) {
    tree.insert_simplex_and_subfaces(std::vector<int>(first, first + corners), 0);
  }
  long euler = 0;
  for (const auto& simplex : tree.complex_simplex_range()) euler += tree.dimension(simplex) % 2 == 0 ? 1 : -1;
  constexpr bool top_dimension_too = true;
  Gudhi::persistent_cohomology::Persistent_cohomology<Gudhi::Simplex_tree<>, Gudhi::persistent_cohomology::Field_Zp>
      cohomology(tree, top_dimension_too);
  cohomology.init_coefficients(p);
  cohomology.compute_persistent_cohomology(0);
  std::vector<int> betti;
  for (int dimension = 0; dimension <= m; ++dimension) betti.push_back(cohomology.betti_number(dimension));
  return {betti, euler};
}

}  // namespace delcert::test
