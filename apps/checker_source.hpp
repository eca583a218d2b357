#pragma once

#include <vector>

#include "proofs/publication/zip_archive.hpp"

namespace delcert {

/// What the checker is built from, below `checker/`, in alphabetical order: as installed beside this program, else from
/// the tree that it was built from. Throws InputError where there is neither.
[[nodiscard]] std::vector<ArchiveFile> checker_source();

}  // namespace delcert
