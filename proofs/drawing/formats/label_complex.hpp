#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "proofs/certificate/reader.hpp"

namespace delcert {

/// The complex of a certificate without coordinates: for programs that ask of it what topologists ask.
struct LabelComplex {
  std::size_t dimension = 0;
  std::vector<std::uint32_t> labels;     ///< of the vertices, in increasing order; those that are in a simplex
  std::vector<std::uint32_t> simplices;  ///< m + 1 vertices each, by their places in `labels`, in increasing order
  bool is_closed = false;                ///< whether every facet is in exactly two simplices

  [[nodiscard]] std::size_t simplex_count() const { return simplices.size() / (dimension + 1); }
};

/// Throws InputError for rows that are not as the format says, and where a facet is in three simplices or more.
[[nodiscard]] LabelComplex label_complex(const CertificateSummary& certificate);

/// How a complex was made smaller.
struct Simplification {
  LabelComplex complex;
  std::size_t contractions = 0;
  std::vector<std::string> homology;  ///< of both, computed for each
};

/// Contracts edges (kernel/topology/edge_contraction.hpp). Throws InputError unless the complex is closed and its
/// certificate claims level 2, which says that it is a manifold; Rejection if the homology is not that of before.
[[nodiscard]] Simplification simplified(const CertificateSummary& certificate, const LabelComplex& complex);

}  // namespace delcert
