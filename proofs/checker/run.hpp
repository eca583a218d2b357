#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/checker/arithmetic/decide.hpp"
#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/certificate/identity.hpp"
#include "proofs/checker/parts/share.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

/// What became of one level: its exit status if it were alone, what was looked at, what is wrong.
struct LevelResult {
  std::string level;
  int status = 0;
  std::string summary;
  std::vector<Finding> findings;
  double seconds = 0;
  std::vector<Range> ranges;
  std::vector<std::string> done, left;  // as in a report

  /// The summary with the counts of the ranges.
  std::string words() const;
};

/// What became of a certificate: the exit status of the format, and the levels that were checked.
struct Outcome {
  int status = 0;
  std::optional<Finding> malformed;
  std::optional<Identity> identity;  // of every document that is not malformed
  std::vector<LevelResult> levels;
  std::vector<std::string> unchecked;  // claimed, but not selected, or resting on a level that does not hold
  Decisions decisions;
  Share share;  // what was checked of it, not more
  // What the certificate states, for those who add up counts.
  std::string content;  // its SHA-256, as in the seal
  std::uint64_t points = 0, simplices = 0;
  std::int64_t euler_characteristic = 0;
  // Of a chunk.
  struct Chunk {
    std::string root;
    std::uint64_t first_label = 0, end_label = 0, first_simplex = 0, end_simplex = 0, trees = 0;
    std::vector<std::array<std::uint64_t, 3>> joins;
    bool operator==(const Chunk&) const = default;
  };
  std::optional<Chunk> chunk;

  bool is_verified() const { return status == 0 && share.is_whole(); }
};

/// Checks the selected levels (all that are claimed if none is selected) and those on which they rest; a level whose
/// base does not hold is not looked at. The text is a decompressed certificate. Throws std::invalid_argument if a
/// selected level is not claimed. If a manifold is expected, as a certificate or a manifold block, another one is
/// rejected (manifold.expected) and no level is looked at. Checks what belongs to `own_share`. Precondition:
/// self_test() found nothing in this thread, and no level is selected for a part.
/// `known`: of the text, if another thread finds it; then it is asked for before any process begins.
Outcome check(std::string_view text, const std::vector<std::string>& selected, std::string_view expected = {},
              const KnownDigest& known = {});

/// The same of one chunk, from 0, of the certificate in the folder: all levels.
Outcome check_chunk(const std::string& folder, std::size_t number);

/// A line for each level and one for the whole; or one JSON object. Only the outcome of a whole that is verified has
/// the word "verified".
std::string as_text(const Outcome& outcome);
std::string as_json(const std::string& file, const Outcome& outcome);

}  // namespace delcert::checker
