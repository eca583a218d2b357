#include "kernel/topology/homology.hpp"

#include <flint/fmpz.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <string>

#include "kernel/topology/integer_matrix.hpp"
#include "kernel/topology/morse_matching.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_entries = std::size_t{1} << 26U;

/// Follows boundaries of critical faces of one dimension down a matching.
class Flow {
 public:
  /// k ≥ 1: the dimension of the critical faces whose boundaries are asked for.
  Flow(const PureComplex& complex, const MorseMatching& matching, int k)
      : complex_(complex), matching_(matching), k_(k), chain_(complex.count(k - 1), 0), row_(chain_.size(), no_row) {
    const auto critical = matching.critical(k - 1);
    for (std::size_t row = 0; row < critical.size(); ++row) row_[critical[row]] = row;
  }
  ~Flow() { clear(); }
  Flow(const Flow&) = delete;
  Flow& operator=(const Flow&) = delete;

  /// Adds the boundary of a critical k-face, in critical faces of dimension k − 1, to a column of the matrix.
  void boundary(std::uint32_t critical_face, IntegerMatrix& matrix, std::size_t column) {
    fmpz minus_one = -1;
    subtract(critical_face, &minus_one);
    while (!places_.empty()) {
      const auto [face, coface] = matching_.pairs(k_ - 1)[places_.top()];
      places_.pop();
      if (fmpz_is_zero(&chain_[face]) != 0) continue;
      // The coface times the coefficient for which the face cancels.
      const auto facets = complex_.facets(k_, coface);
      const auto omitted = std::find(facets.begin(), facets.end(), face) - facets.begin();
      fmpz factor = 0;
      fmpz_set(&factor, &chain_[face]);
      if (omitted % 2 != 0) fmpz_neg(&factor, &factor);
      subtract(coface, &factor);
      fmpz_clear(&factor);
    }
    for (const std::uint32_t face : touched_) {
      if (row_[face] != no_row) fmpz_set(matrix.entry(row_[face], column), &chain_[face]);
    }
    clear();
  }

 private:
  static constexpr std::size_t no_row = static_cast<std::size_t>(-1);

  /// Subtracts a multiple of the boundary of a k-face from the chain.
  void subtract(std::uint32_t face, const fmpz* factor) {
    bool negative = false;
    for (const std::uint32_t facet : complex_.facets(k_, face)) {
      if (negative) {
        fmpz_add(&chain_[facet], &chain_[facet], factor);
      } else {
        fmpz_sub(&chain_[facet], &chain_[facet], factor);
      }
      negative = !negative;
      touched_.push_back(facet);
      const std::uint32_t place = matching_.place(k_ - 1, facet);
      if (place != MorseMatching::none && fmpz_is_zero(&chain_[facet]) == 0) places_.push(place);
    }
  }
  void clear() {
    for (const std::uint32_t face : touched_) fmpz_zero(&chain_[face]);
    touched_.clear();
  }

  const PureComplex& complex_;
  const MorseMatching& matching_;
  int k_;
  std::vector<fmpz> chain_;       // a coefficient for each face of dimension k − 1
  std::vector<std::size_t> row_;  // of critical faces of dimension k − 1
  std::vector<std::uint32_t> touched_;
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> places_;
};

/// The invariant factors of the boundary from critical k-faces to critical (k−1)-faces.
std::vector<Integer> boundary_factors(const PureComplex& complex, const MorseMatching& matching, int k) {
  const auto critical = matching.critical(k);
  const std::size_t rows = matching.critical(k - 1).size();
  if (rows > 0 && critical.size() > most_entries / rows) {
    throw Undecided("homology: " + std::to_string(critical.size()) + " critical faces of dimension " +
                    std::to_string(k) + " over " + std::to_string(rows) + " are too many for a dense matrix");
  }
  IntegerMatrix matrix(rows, critical.size());
  Flow flow(complex, matching, k);
  for (std::size_t column = 0; column < critical.size(); ++column) flow.boundary(critical[column], matrix, column);
  return matrix.invariant_factors();
}

}  // namespace

std::vector<AbelianGroup> homology(const PureComplex& complex) {
  const MorseMatching matching(complex);
  std::vector<AbelianGroup> groups(static_cast<std::size_t>(complex.dimension()) + 1);
  std::size_t rank = 0;  // of the boundary from dimension k
  for (int k = 0; k <= complex.dimension(); ++k) {
    AbelianGroup& group = groups[static_cast<std::size_t>(k)];
    group.free_rank = matching.critical(k).size() - rank;
    if (k == complex.dimension()) break;
    const std::vector<Integer> factors = boundary_factors(complex, matching, k + 1);
    rank = factors.size();
    group.free_rank -= rank;
    std::copy_if(factors.begin(), factors.end(), std::back_inserter(group.torsion),
                 [](const Integer& factor) { return factor != 1; });
  }
  return groups;
}

}  // namespace delcert
