#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kernel/stars/stable_stars.hpp"

namespace delcert {

/// Level 2s of a run in charts: how far these have to show for its stars to be the same in all of them; or nothing, and
/// a reason is appended. `own_reach` is what the stars need in their own charts; `fits` says what lies in the patches.
[[nodiscard]] std::optional<Rational> derive_reach(const StarStability& stability, double own_reach,
                                                   const std::function<bool(const Rational&)>& fits,
                                                   std::vector<std::string>& reasons);

}  // namespace delcert
