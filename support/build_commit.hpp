#pragma once

namespace delcert {

/// The commit from which this program was configured, in hexadecimal; empty where the sources are in no repository. The
/// definition is generated (cmake/Commit.cmake).
[[nodiscard]] const char* build_commit();

}  // namespace delcert
