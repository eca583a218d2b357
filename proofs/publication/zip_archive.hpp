#pragma once

#include <string>
#include <vector>

namespace delcert {

struct ArchiveFile {
  std::string name;  ///< with folders, separated by /
  std::string bytes;
};

/// A ZIP archive of these files, in this order, stored as they are and dated 1980-01-01: equal files give equal bytes.
/// Throws std::invalid_argument for a name twice, and std::length_error for more than the format can hold: 65 534
/// files, four gigabytes.
[[nodiscard]] std::string zip_archive(const std::vector<ArchiveFile>& files);

}  // namespace delcert
