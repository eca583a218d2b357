#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "kernel/stars/chart_complex.hpp"

// Complexes of space forms for comparison with other software: sets of labels.
namespace delcert::test {

/// m-simplices as their sorted labels, in increasing order, each once.
template <int m>
using LabelComplex = std::vector<LabelSimplex<m>>;

template <int m>
void sort_simplices(LabelComplex<m>& simplices) {
  for (auto& simplex : simplices) std::sort(simplex.begin(), simplex.end());
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
}

/// Empty if the complexes are equal; else what only one of them has.
template <int m>
std::string label_disagreement(const LabelComplex<m>& ours, const LabelComplex<m>& theirs) {
  constexpr std::size_t most_shown = 5;
  LabelComplex<m> different;
  std::set_symmetric_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(), std::back_inserter(different));
  if (different.empty()) return "";
  std::string result = std::to_string(different.size()) + " simplices of one complex only:";
  for (std::size_t at = 0; at < std::min(different.size(), most_shown); ++at) {
    result += " " + simplex_text(std::vector<Label>(different[at].begin(), different[at].end()));
    result += std::binary_search(ours.begin(), ours.end(), different[at]) ? " (ours)" : " (theirs)";
  }
  return result;
}

/// The complex after one bistellar flip: two simplices at a facet give way to the m simplices at the segment between
/// their apexes. What comes out is closed again, so that counting simplices at facets does not notice.
template <int m>
LabelComplex<m> with_one_flip_of_labels(LabelComplex<m> simplices) {
  const LabelSimplex<m> first = simplices.front();
  const auto facet_count = [&](const LabelSimplex<m>& other) {
    return std::count_if(first.begin(), first.end(),
                         [&](auto label) { return std::binary_search(other.begin(), other.end(), label); });
  };
  const auto found =
      std::find_if(simplices.begin(), simplices.end(), [&](const auto& other) { return facet_count(other) == m; });
  if (found == simplices.end()) {
    ADD_FAILURE() << "no two simplices share a facet";
    return simplices;
  }
  const LabelSimplex<m> second = *found;
  std::vector<std::uint32_t> facet;
  std::vector<std::uint32_t> apexes;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(facet));
  std::set_symmetric_difference(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(apexes));
  std::erase_if(simplices, [&](const auto& simplex) { return simplex == first || simplex == second; });
  for (std::size_t replaced = 0; replaced < m; ++replaced) {
    LabelSimplex<m> simplex;
    std::copy(facet.begin(), facet.end(), simplex.begin());
    simplex[replaced] = apexes[0];
    simplex[m] = apexes[1];
    simplices.push_back(simplex);
  }
  sort_simplices<m>(simplices);
  return simplices;
}

/// Asserts that both are the same and that a flip would not get through.
template <int m>
void expect_same_labels(const LabelComplex<m>& ours, const LabelComplex<m>& theirs) {
  EXPECT_EQ(label_disagreement<m>(ours, theirs), "");
  EXPECT_NE(label_disagreement<m>(with_one_flip_of_labels<m>(ours), theirs), "");
}

}  // namespace delcert::test
