#include "proofs/drawing/formats/gluings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace delcert {
namespace DELCERT_THIS_FILE {

/// All permutations of `size` in lexicographic order.
std::vector<Gluings::Permutation> permutations(std::size_t size) {
  Gluings::Permutation permutation{};
  const auto end = permutation.begin() + static_cast<std::ptrdiff_t>(size);
  std::iota(permutation.begin(), end, std::uint8_t{0});
  std::vector<Gluings::Permutation> result;
  do {
    result.push_back(permutation);
  } while (std::next_permutation(permutation.begin(), end));
  return result;
}

TEST(Gluings, PermutationsAreNumbered) {
  for (std::size_t size = 2; size <= 5; ++size) {
    const auto all = permutations(size);
    std::set<std::uint32_t> alternating;
    for (std::uint32_t k = 0; k < all.size(); ++k) {
      EXPECT_EQ(lexicographic_index(all[k], size), k);
      alternating.insert(alternating_index(all[k], size));
      EXPECT_EQ(alternating_index(all[k], size) % 2 == 0, is_even(all[k], size));
    }
    EXPECT_EQ(alternating.size(), all.size());
    EXPECT_EQ(*alternating.rbegin(), all.size() - 1);
  }
}

LabelComplex complex_of(std::size_t dimension, std::vector<std::uint32_t> simplices) {
  LabelComplex result;
  result.dimension = dimension;
  for (std::uint32_t label = 0; label <= *std::max_element(simplices.begin(), simplices.end()); ++label)
    result.labels.push_back(label);
  result.simplices = std::move(simplices);
  return result;
}

/// The boundary of a simplex of dimension m + 1.
LabelComplex sphere(std::uint32_t m) {
  std::vector<std::uint32_t> simplices;
  for (std::uint32_t without = 0; without < m + 2; ++without) {
    for (std::uint32_t k = 0; k < m + 2; ++k) {
      if (k != without) simplices.push_back(k);
    }
  }
  return complex_of(m, std::move(simplices));
}

TEST(Gluings, GoBackAndForth) {
  for (const std::uint32_t m : {2U, 3U, 4U}) {
    Gluings gluings(sphere(m));
    for (const bool is_oriented : {false, true}) {
      if (is_oriented) {
        ASSERT_TRUE(gluings.orient());
      }
      for (std::uint32_t simplex = 0; simplex < gluings.count(); ++simplex) {
        for (std::size_t facet = 0; facet <= m; ++facet) {
          const Gluings::Gluing& there = gluings.at(simplex, facet);
          const Gluings::Gluing& back = gluings.at(there.simplex, there.vertices[facet]);
          EXPECT_EQ(back.simplex, simplex);
          for (std::size_t k = 0; k <= m; ++k) EXPECT_EQ(back.vertices[there.vertices[k]], k);
          if (is_oriented) {
            EXPECT_FALSE(is_even(there.vertices, m + 1));
          }
        }
      }
    }
  }
}

TEST(Gluings, OfTheProjectivePlaneCannotBeOriented) {
  Gluings gluings(
      complex_of(2, {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 1, 5, 1, 2, 4, 2, 3, 5, 1, 3, 4, 2, 4, 5, 1, 3, 5}));
  EXPECT_FALSE(gluings.orient());
}

TEST(Gluings, EndAtABoundary) {
  const Gluings gluings(complex_of(2, {0, 1, 2, 1, 2, 3}));
  EXPECT_EQ(gluings.at(0, 0).simplex, 1U);
  EXPECT_EQ(gluings.at(0, 0).vertices[0], 2);
  EXPECT_EQ(gluings.at(0, 1).simplex, Gluings::boundary);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
