#pragma once

#include <string>

namespace delcert {

/// The name of this machine, as the system has it; "unknown" where it has none.
[[nodiscard]] std::string host_name();

}  // namespace delcert
