#include "apps/checker_path.hpp"

#include <unistd.h>

#include <system_error>

namespace delcert {

namespace fs = std::filesystem;

std::vector<fs::path> checker_candidates(const fs::path& executable, std::string_view search_path) {
  const fs::path folder = executable.parent_path();
  std::vector<fs::path> candidates{folder / "delcert-check",
                                   (folder / ".." / "proofs" / "checker" / "delcert-check").lexically_normal()};
  while (!search_path.empty()) {
    const std::size_t end = std::min(search_path.find(':'), search_path.size());
    if (end != 0) candidates.push_back(fs::path(search_path.substr(0, end)) / "delcert-check");
    search_path.remove_prefix(std::min(end + 1, search_path.size()));
  }
  return candidates;
}

fs::path first_executable(const std::vector<fs::path>& candidates) {
  for (const fs::path& candidate : candidates) {
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored) && access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  return {};
}

}  // namespace delcert
