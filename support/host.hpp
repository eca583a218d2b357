#pragma once

#include <string>

namespace delcert {

/// The name of this machine, as the system has it; "unknown" where it has none.
[[nodiscard]] std::string host_name();

/// Gives memory that was released back to the system, where the allocator would keep it: other processes need it.
void return_free_memory();

}  // namespace delcert
