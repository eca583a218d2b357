#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/replay/statement.hpp"

namespace delcert::replay {

/// What a parameter runs through, as a file states it: "(0, 1/4]", "integer [1, infinity)".
struct StatedRange {
  bool is_integer = false;
  std::optional<Number> lower;  ///< nothing: −∞
  std::optional<Number> upper;  ///< nothing: ∞
  bool has_lower = false;
  bool has_upper = false;

  friend bool operator==(const StatedRange&, const StatedRange&) = default;
};

/// Throws Malformed.
StatedRange read_range(const std::string& text);
std::string text_of(const StatedRange& range);

/// A step as its file states it, constants, abbreviations and definitions replaced by what they stand for.
struct StatedStep {
  std::map<std::string, StatedRange> parameters;
  std::vector<std::string> hypotheses;  ///< S-expressions
  std::string statement;
  std::size_t line = 0;  ///< of the file, where its table begins
};

/// The steps of one claim's file by name.
struct StatedClaim {
  std::string source;  ///< the file
  std::string sha256;  ///< of its text
  std::map<std::string, StatedStep> steps;
};

/// Claims by name.
using StatedClaims = std::map<std::string, StatedClaim>;

/// Reads the [[step]] tables of a claim's file (docs/claim-format.md, "Steps"), with code of its own, and adds the
/// claim; one of the same name that is there already is replaced. Throws Malformed, naming the source.
void add_claim(StatedClaims& claims, std::string_view text, const std::string& source);

/// The claims of the library, which this program has as texts.
StatedClaims builtin_claims_as_stated();

}  // namespace delcert::replay
