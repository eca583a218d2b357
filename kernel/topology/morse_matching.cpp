#include "kernel/topology/morse_matching.hpp"

namespace delcert {

namespace {

/// The k-faces that are left at a face of dimension k − 1: how many, and the exclusive or of their numbers, which is
/// the number of the last one.
struct Cofaces {
  std::uint32_t count = 0;
  std::uint32_t combined = 0;
};

}  // namespace

MorseMatching::MorseMatching(const PureComplex& complex) : levels_(static_cast<std::size_t>(complex.dimension()) + 1) {
  for (int k = 0; k <= complex.dimension(); ++k) {
    levels_[static_cast<std::size_t>(k)].place.assign(complex.count(k), none);
  }
  for (int k = complex.dimension(); k > 0; --k) collapse(complex, k);
  for (std::uint32_t vertex = 0; vertex < complex.count(0); ++vertex) {
    if (levels_[0].place[vertex] == none) levels_[0].critical.push_back(vertex);
  }
}

/// Removes all k-faces that are not matched with cofaces.
void MorseMatching::collapse(const PureComplex& complex, int k) {
  Level& level = levels_[static_cast<std::size_t>(k)];
  Level& below = levels_[static_cast<std::size_t>(k) - 1];
  std::vector<bool> left(complex.count(k));
  std::vector<Cofaces> cofaces(complex.count(k - 1));
  for (std::uint32_t face = 0; face < left.size(); ++face) {
    left[face] = level.place[face] == none;
    if (!left[face]) continue;
    for (const std::uint32_t facet : complex.facets(k, face)) {
      ++cofaces[facet].count;
      cofaces[facet].combined ^= face;
    }
  }
  std::vector<std::uint32_t> free;  // each face comes here once, when one coface is left; that may be gone later
  for (std::uint32_t facet = 0; facet < cofaces.size(); ++facet) {
    if (cofaces[facet].count == 1) free.push_back(facet);
  }
  const auto remove = [&](std::uint32_t face) {
    left[face] = false;
    for (const std::uint32_t facet : complex.facets(k, face)) {
      --cofaces[facet].count;
      cofaces[facet].combined ^= face;
      if (cofaces[facet].count == 1) free.push_back(facet);
    }
  };
  std::size_t next_free = 0;
  for (std::uint32_t first_left = 0;;) {
    for (; next_free < free.size(); ++next_free) {
      const std::uint32_t facet = free[next_free];
      if (cofaces[facet].count != 1) continue;
      below.place[facet] = static_cast<std::uint32_t>(below.pairs.size());
      below.pairs.push_back({facet, cofaces[facet].combined});
      remove(cofaces[facet].combined);
    }
    while (first_left < left.size() && !left[first_left]) ++first_left;
    if (first_left == left.size()) return;
    level.critical.push_back(first_left);
    remove(first_left);
  }
}

}  // namespace delcert
