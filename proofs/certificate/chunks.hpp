#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace delcert {

/// Divides a certificate of a space form into so many chunks of consecutive labels, and writes them to a folder, which
/// is made, with a header that has all else (docs/certificate-in-chunks.md). What `homology` states is left out. Chunks
/// have as many labels as each other, or one less. Nothing is verified, only copied. The header comes last, so that a
/// folder with a header is complete. Returns the root of the tree of digests.
///
/// Throws InputError if the text is no certificate of a space form of version 2, or has fewer labels than chunks, or
/// there are fewer than 2; or if the folder has a header.
std::string write_chunks(const std::string& certificate, std::size_t chunks, const std::filesystem::path& folder);

// Its parts, for those that have a certificate only in pieces.

/// Which labels are in which of so many chunks, counted from 0.
struct ChunkRanges {
  std::size_t labels = 0;
  std::size_t chunks = 1;

  [[nodiscard]] std::size_t first_of(std::size_t chunk) const;
  [[nodiscard]] std::size_t chunk_of(std::size_t label) const;
};

/// The text of a chunk. Rows are JSON arrays, added in the order of the format.
class ChunkText {
 public:
  void add_rows(std::string_view key, std::size_t count, const std::function<std::string_view(std::size_t)>& row);
  /// Nothing may be added afterwards.
  [[nodiscard]] const std::string& finished();

 private:
  std::string text_ = R"({"format":"delcert-chunk","version":1)";
};

/// What the header says of a chunk.
struct ChunkEntry {
  std::size_t first = 0;  ///< label
  std::size_t own = 0;    ///< simplices whose least label is in the chunk
  std::string digest;
};

/// Makes the folder. Throws InputError if it has a header.
void prepare_chunk_folder(const std::filesystem::path& folder);
/// Writes the chunk that is counted from 0 by this number. Returns its digest.
[[nodiscard]] std::string write_chunk(const std::filesystem::path& folder, std::size_t chunk, std::string_view text);
/// Writes the header, after all chunks. `head` is what `certificate_head` has, `elements` and `loops` are JSON. Returns
/// the root.
std::string write_chunk_header(const std::filesystem::path& folder, std::size_t labels,
                               const std::vector<ChunkEntry>& entries, std::string_view head, std::string_view elements,
                               std::string_view loops);

}  // namespace delcert
