#pragma once

#include <chrono>
#include <string>

namespace delcert {

/// A time of day as logs have it, in whole seconds of UTC: "2026-05-31T23:59:07Z".
[[nodiscard]] std::string utc_text(std::chrono::system_clock::time_point time);

/// And back. Throws InputError for anything else, and for a day that no calendar has.
[[nodiscard]] std::chrono::sys_seconds parse_utc(const std::string& text);

}  // namespace delcert
