#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "proofs/checker/certificate/chunks.hpp"
#include "proofs/checker/core/complex.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

/// One chunk of a certificate and what is near it; the rules that only certificates in chunks have
/// (docs/certificate-in-chunks.md).
class ChunkView {
 public:
  /// Chunk number k, from 0. Keeps a reference.
  ChunkView(Chunks& chunks, std::size_t number) : chunks_(chunks), number_(number) {}

  Chunks& chunks() const { return chunks_; }
  std::size_t number() const { return number_; }

  /// The labels that are so many edges from the chunk or fewer, and their simplices but those that have only labels
  /// that are as far as that; with numbers of their own for labels and simplices, which `chunk_items` then describes.
  struct Near {
    std::vector<std::string_view> net, points;
    std::vector<Label> labels;
    std::vector<std::uint32_t> elements;
  };
  Near near(std::size_t m, unsigned edges);

  /// chunk.border: every simplex of this chunk is in each of the chunks of its labels.
  void check_border(Report& report);
  /// core.group in chunks: each loop is closed at label 0, the product along it is its generator, and the simplices of
  /// its steps, as far as their least label is in this chunk, are in the chunk.
  void check_loops(core::Complex& complex, Report& report);
  std::vector<std::vector<ChunkStep>> loops;

  /// How many components the graph of the labels and edges in this chunk has; and, for each of these trees and each
  /// tree of a chunk before this one, whether an edge joins them: tree, chunk, tree there.
  std::uint32_t trees();
  std::vector<std::array<std::uint64_t, 3>> joins();

 private:
  Chunks& chunks_;
  std::size_t number_;
};

}  // namespace delcert::checker
