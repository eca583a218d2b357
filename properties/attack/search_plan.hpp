#pragma once

#include <filesystem>
#include <vector>

#include "properties/attack/tighten.hpp"

namespace delcert {

/// One conclusion of one claim in one shape, to be searched with a number of instances.
struct SearchTarget {
  Claim claim;
  std::size_t conclusion = 0;
  Shape shape;
  std::uint64_t evaluations = 0;
};

struct SearchPlan {
  std::vector<SearchTarget> targets;
  std::uint64_t seed = 0;
  unsigned threads = 1;
  /// JSON lines, one for each finished target with its witness, which is judged anew when the log is read; what it has
  /// already is not searched again. Nothing is kept if empty.
  std::filesystem::path log;
};

/// What `tighten` finds for each target, in their order: the same for any number of threads, and whether or not it was
/// interrupted and resumed. `progress` is called from the calling thread and may throw to end the search: targets that
/// are finished stay in the log. Throws InputError for a log that belongs to another plan, and, naming claim and shape,
/// where a claim cannot be asked of its instances.
[[nodiscard]] std::vector<std::optional<Tightest>> run_searches(const SearchPlan& plan, const Progress& progress);

}  // namespace delcert
