#pragma once

#include <string>

namespace delcert {

/// What draws and decides here, for logs of campaigns: version and commit.
[[nodiscard]] std::string software_name();

/// So many threads as were asked for; as many as there are processors for 0.
[[nodiscard]] unsigned threads_or_all(unsigned threads);

}  // namespace delcert
