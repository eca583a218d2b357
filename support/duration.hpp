#pragma once

#include <chrono>
#include <string>

namespace delcert {

/// A whole number with its unit: "90s", "45min", "8h", "2d"; from 1 s to 366 d. Throws InputError for anything else.
[[nodiscard]] std::chrono::seconds parse_duration(const std::string& text);

/// Rounded up to whole seconds and then down: "119 s", "2 min" up to "119 min", then "4 h 57 min".
[[nodiscard]] std::string duration_text(std::chrono::milliseconds duration);

}  // namespace delcert
