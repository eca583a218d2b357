#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/number/strong.hpp"

namespace delcert {

/// The abstract simplicial complex of all faces of given simplices of one dimension m, each a set of m + 1 labels. The
/// faces of each dimension are numbered in the lexicographic order of their labels. Nothing is known of where the
/// labels come from: two simplices share what labels they share.
class PureComplex {
 public:
  /// `labels`: m + 1 for each simplex, in any order; a simplex that is given twice counts once. None at all give the
  /// empty complex. Takes time linear in the number of labels, for each dimension.
  /// Throws InputError for a simplex that has a label twice, std::invalid_argument unless m ≥ 0 and the number of
  /// labels is a multiple of m + 1.
  PureComplex(Dimension dimension, const std::vector<std::uint32_t>& labels);

  [[nodiscard]] int dimension() const { return static_cast<int>(faces_.size()) - 1; }
  /// The number of faces of dimension k; 0 unless 0 ≤ k ≤ m.
  [[nodiscard]] std::size_t count(int k) const;
  /// Σ (−1)^k count(k).
  [[nodiscard]] std::int64_t euler_characteristic() const;

  /// The vertices of a k-face, in increasing order: their places among the sorted labels. Precondition: face <
  /// count(k).
  [[nodiscard]] std::span<const std::uint32_t> vertices(int k, std::size_t face) const;
  /// The k + 1 faces of dimension k − 1 of a k-face; the i-th is without the i-th vertex, so that the boundary of the
  /// k-face is the sum of (−1)^i times the i-th. Precondition: k ≥ 1, face < count(k).
  [[nodiscard]] std::span<const std::uint32_t> facets(int k, std::size_t face) const;

 private:
  struct Faces {
    std::vector<std::uint32_t> vertices;  // k + 1 to a face
    std::vector<std::uint32_t> facets;    // k + 1 to a face, if k ≥ 1
  };
  std::vector<Faces> faces_;  // by dimension
};

}  // namespace delcert
