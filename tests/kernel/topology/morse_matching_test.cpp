#include "kernel/topology/morse_matching.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/topology/known_complexes.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::vector<std::size_t> critical_counts(const MorseMatching& matching, int m) {
  std::vector<std::size_t> result;
  for (int k = 0; k <= m; ++k) result.push_back(matching.critical(k).size());
  return result;
}

std::vector<std::size_t> critical_counts(const LabelComplex& labels) {
  return critical_counts(MorseMatching(PureComplex(Dimension(labels.dimension), labels.labels)), labels.dimension);
}

TEST(MorseMatching, has_every_face_once_and_removes_it_from_the_outside) {
  for (const KnownComplex& known : known_complexes()) {
    SCOPED_TRACE(known.name);
    const int m = known.complex.dimension;
    const PureComplex complex(Dimension(m), known.complex.labels);
    const MorseMatching matching(complex);
    std::vector<std::vector<int>> seen(static_cast<std::size_t>(m) + 1);
    for (int k = 0; k <= m; ++k) seen[static_cast<std::size_t>(k)].assign(complex.count(k), 0);
    for (int k = 0; k <= m; ++k) {
      const auto at = static_cast<std::size_t>(k);
      for (const std::uint32_t face : matching.critical(k)) {
        ++seen[at][face];
        EXPECT_EQ(matching.place(k, face), MorseMatching::none);
      }
      if (k == m) {
        EXPECT_TRUE(matching.pairs(k).empty());
        break;
      }
      const auto pairs = matching.pairs(k);
      for (std::uint32_t place = 0; place < pairs.size(); ++place) {
        const auto [face, coface] = pairs[place];
        ++seen[at][face];
        ++seen[at + 1][coface];
        EXPECT_EQ(matching.place(k, face), place);
        EXPECT_EQ(matching.place(k + 1, coface), MorseMatching::none);
        const auto facets = complex.facets(k + 1, coface);
        EXPECT_EQ(std::count(facets.begin(), facets.end(), face), 1);
        for (const std::uint32_t other : facets) {
          if (other == face) continue;
          EXPECT_GT(matching.place(k, other), place);
        }
      }
    }
    for (const auto& counts : seen) EXPECT_EQ(std::count(counts.begin(), counts.end(), 1), std::ssize(counts));
  }
}

TEST(MorseMatching, leaves_few_critical_faces) {
  EXPECT_EQ(critical_counts(smallest_sphere(4)), (std::vector<std::size_t>{1, 0, 0, 0, 1}));
  EXPECT_EQ(critical_counts(seven_vertex_torus()), (std::vector<std::size_t>{1, 2, 1}));
  EXPECT_EQ(critical_counts(six_vertex_projective_plane()), (std::vector<std::size_t>{1, 1, 1}));
  EXPECT_EQ(critical_counts(without_simplex(smallest_sphere(3), 0)), (std::vector<std::size_t>{1, 0, 0, 0}));
  // Contractible, but no triangle has a free edge.
  const auto hat = critical_counts(glued_polygon("aaA"));
  EXPECT_GE(hat[2], 1U);
  EXPECT_EQ(hat[0] + hat[2], hat[1] + 1);
  for (const KnownComplex& known : known_complexes()) {
    const auto counts = critical_counts(known.complex);
    for (const std::size_t count : counts) EXPECT_LT(count, 40U) << known.name;
    if (!known.closed_manifold || known.homology[0] != "Z") continue;
    EXPECT_EQ(counts.back(), 1U) << known.name;
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
