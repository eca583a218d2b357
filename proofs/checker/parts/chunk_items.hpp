#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace delcert::checker {

/// What a loop goes over.
enum class Items { others, labels, simplices, facets };

/// What the check of a chunk knows of the whole (docs/certificate-in-chunks.md). Labels, simplices and facets that were
/// read have numbers of their own here, in the order of those of the certificate.
struct ChunkItems {
  /// From which to which one they are the chunk's; which one is the first in the certificate, and of how many.
  struct Part {
    std::uint64_t begin = 0, end = 0, first = 0, of = 0;
  };
  Part labels, simplices;
  std::uint64_t facets = 0;          // of the whole; the facets that are found are the chunk's
  std::vector<std::uint32_t> names;  // of each label here, the label of the certificate
  std::vector<bool> whole;           // of each label here, whether all of its simplices have been read
};
/// None if the whole certificate has been read.
inline std::optional<ChunkItems> chunk_items;

/// The check looks at simplices that have not been read.
struct NotRead : std::exception {
  const char* what() const noexcept override { return "what is near the chunk has not been read"; }
};
/// Throws NotRead unless all simplices with this label have been read.
inline void require_star(std::uint32_t label) {
  if (chunk_items && !chunk_items->whole[label]) throw NotRead();
}
/// Whether a simplex or a facet with this least label is the chunk's, or the whole certificate has been read.
inline bool is_own(std::uint32_t least_label) {
  return !chunk_items || (chunk_items->labels.begin <= least_label && least_label < chunk_items->labels.end);
}
/// The label as the certificate has it.
inline std::string name_of(std::uint32_t label) {
  return std::to_string(chunk_items && label < chunk_items->names.size() ? chunk_items->names[label] : label);
}

}  // namespace delcert::checker
