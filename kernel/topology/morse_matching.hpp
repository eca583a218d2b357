#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "kernel/topology/pure_complex.hpp"

namespace delcert {

/// An acyclic matching of the faces of a complex, found by collapses, from the highest dimension down: while a face of
/// dimension k − 1 lies in exactly one k-face that is left, the two are matched and removed; when there is none, the
/// first k-face that is left is critical and removed. Depends on the complex only, and takes linear time. On a
/// connected closed surface the critical faces are as few as its homology over 𝔽₂ allows in dimension 2. Source:
/// Forman, "Morse theory for cell complexes" (1998); the strategy is that of Benedetti and Lutz, "Random discrete Morse
/// theory and a new library of triangulations" (2014), without the randomness.
class MorseMatching {
 public:
  /// A face of dimension k and the face of dimension k + 1 that it was matched with.
  struct Pair {
    std::uint32_t face;
    std::uint32_t coface;
  };
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  explicit MorseMatching(const PureComplex& complex);

  /// The critical k-faces, in the order in which they were removed; 0 ≤ k ≤ m.
  [[nodiscard]] std::span<const std::uint32_t> critical(int k) const { return at(k).critical; }
  /// The matched faces of dimension k with their cofaces, in the order in which they were removed: another face of a
  /// coface is in a later pair or in none.
  [[nodiscard]] std::span<const Pair> pairs(int k) const { return at(k).pairs; }
  /// The place of the k-face in pairs(k), or `none` if it is critical or matched with a face of its own.
  [[nodiscard]] std::uint32_t place(int k, std::size_t face) const { return at(k).place[face]; }

 private:
  struct Level {
    std::vector<std::uint32_t> critical;
    std::vector<Pair> pairs;
    std::vector<std::uint32_t> place;
  };
  [[nodiscard]] const Level& at(int k) const { return levels_[static_cast<std::size_t>(k)]; }
  void collapse(const PureComplex& complex, int k);

  std::vector<Level> levels_;  // by dimension
};

}  // namespace delcert
