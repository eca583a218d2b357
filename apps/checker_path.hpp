#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace delcert {

/// Where delcert-check may be, the most likely place first: beside `executable`, where a build tree has it, and in the
/// folders of `search_path` (as in the environment variable PATH).
[[nodiscard]] std::vector<std::filesystem::path> checker_candidates(const std::filesystem::path& executable,
                                                                    std::string_view search_path);

/// The first candidate that is an executable file; empty if none is.
[[nodiscard]] std::filesystem::path first_executable(const std::vector<std::filesystem::path>& candidates);

}  // namespace delcert
