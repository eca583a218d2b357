#pragma once

#include <filesystem>

namespace delcert {

/// The root of the sources, of which this file is in tests/proofs/formula/.
inline std::filesystem::path source_folder() {
  return std::filesystem::path(__FILE__).parent_path().parent_path().parent_path().parent_path();
}

}  // namespace delcert
