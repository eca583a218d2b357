#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/checker/certificate/cursor.hpp"
#include "proofs/checker/geometry/point_set.hpp"

namespace delcert::checker {

/// One edge of a loop that goes through chunks: from the vertex at one place of a simplex to that at another.
struct ChunkStep {
  std::vector<Label> labels;            // m + 1
  std::vector<std::uint32_t> elements;  // m
  std::uint32_t from = 0, to = 0;
};

/// What one file of a certificate in chunks has: the points of its labels, and all simplices with one of them.
struct Chunk {
  std::string text;
  std::vector<std::string_view> net, points;  // m to a point
  std::vector<Label> labels;                  // m + 1 to a simplex, sorted
  std::vector<std::uint32_t> elements;        // m to a simplex
  std::vector<std::uint64_t> star_begin;      // of each label, with one more at the end
  std::vector<std::uint32_t> star;            // numbers of simplices
};

/// The folder of a certificate in chunks, read chunk by chunk (docs/certificate-in-chunks.md).
class Chunks {
 public:
  struct Entry {
    Label first = 0;              // its first label
    std::uint64_t simplices = 0;  // how many have their least label in it
    std::string digest;
  };

  explicit Chunks(std::string folder) : folder_(std::move(folder)) {}

  /// The header, decompressed. Throws Unreadable, Malformed.
  const std::string& header();
  /// The part of the header that says which chunks there are. Throws Malformed: chunk.root, form.*.
  void read_table(Cursor& cursor);
  /// Precondition of what follows.
  void set_dimension(std::size_t m) { m_ = m; }

  Label points() const { return points_; }
  std::uint64_t simplices() const;
  std::size_t size() const { return entries_.size(); }
  const std::string& root() const { return root_; }
  Label first(std::size_t k) const { return entries_[k].first; }
  /// One more than the last label.
  Label end(std::size_t k) const { return k + 1 < entries_.size() ? entries_[k + 1].first : points_; }
  /// How many simplices have their least label in a chunk before.
  std::uint64_t simplices_before(std::size_t k) const;
  std::size_t chunk_of(Label label) const;

  /// Read where it was not before. Throws Malformed: chunk.file, chunk.digest, chunk.labels, form.*.
  const Chunk& chunk(std::size_t k);
  /// The number of a simplex in a chunk, or one more than the last.
  std::size_t find(const Chunk& chunk, const Label* labels) const;
  /// Of each label of the chunk, the number of its tree: the components of the graph of labels and edges in the chunk,
  /// numbered by their least labels.
  const std::vector<std::uint32_t>& trees(std::size_t k);

 private:
  void parse(std::size_t k, Chunk& chunk) const;

  std::string folder_, header_, root_;
  std::size_t m_ = 0;
  Label points_ = 0;
  std::vector<Entry> entries_;
  std::map<std::size_t, Chunk> read_;
  std::map<std::size_t, std::vector<std::uint32_t>> trees_;
};

/// The root of the binary tree of SHA-256 above these leaves, in lower-case hexadecimal digits: of a leaf, of the byte
/// 0 and its bytes; of a node, of the byte 1 and the digests of its two children. A node without a second child is its
/// child.
std::string merkle_root(std::vector<std::string> leaves);
std::string leaf_digest(std::string_view bytes);

}  // namespace delcert::checker
