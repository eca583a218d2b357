#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace delcert {

/// Called now and then by long work, in the thread that does it: what is being done, how much of it is done. It may
/// throw to give up; nothing half-finished is kept then. Never called under a rounding guard.
using Progress = std::function<void(std::string_view stage, std::size_t done, std::size_t total)>;

/// For callers that do not want to know.
[[nodiscard]] inline Progress no_progress() {
  return [](std::string_view, std::size_t, std::size_t) {};
}

}  // namespace delcert
