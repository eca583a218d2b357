#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "proofs/drawing/formats/label_complex.hpp"

namespace delcert {

/// A complex as simplices whose facets are glued in pairs: how Regina and SnapPea have it. The facet of vertex k of a
/// simplex is the one without it.
class Gluings {
 public:
  static constexpr std::uint32_t boundary = UINT32_MAX;
  /// Where the vertices 0 … m go.
  using Permutation = std::array<std::uint8_t, 5>;
  struct Gluing {
    std::uint32_t simplex = boundary;  ///< the neighbour
    Permutation vertices{};            ///< of this simplex in it; the vertex k goes to the one beyond the facet
  };

  /// Precondition: a facet is in at most two simplices, dimension ≥ 1.
  explicit Gluings(const LabelComplex& complex);

  [[nodiscard]] std::size_t dimension() const { return size_ - 1; }
  [[nodiscard]] std::size_t count() const { return gluings_.size() / size_; }
  [[nodiscard]] const Gluing& at(std::size_t simplex, std::size_t facet) const {
    return gluings_[simplex * size_ + facet];
  }
  /// Exchanges the last two vertices of some simplices, so that all gluings are odd. False, and nothing is changed,
  /// where that cannot be.
  [[nodiscard]] bool orient();

 private:
  std::size_t size_;
  std::vector<Gluing> gluings_;
};

/// Whether it is even.
[[nodiscard]] bool is_even(const Gluings::Permutation& permutation, std::size_t size);
/// Its place in the lexicographic list of all; and in Regina's list, where even and odd ones alternate.
[[nodiscard]] std::uint32_t lexicographic_index(const Gluings::Permutation& permutation, std::size_t size);
[[nodiscard]] std::uint32_t alternating_index(const Gluings::Permutation& permutation, std::size_t size);

}  // namespace delcert
