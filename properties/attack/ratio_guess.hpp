#pragma once

#include <string>

#include "proofs/formula/decision.hpp"

namespace delcert {

/// What the supremum of a ratio looks like, by the worst that a search has found: `looks like 1/4, not attained`,
/// `looks like sqrt(1/2)`, `looks unbounded` above 10⁶; "" if it looks like nothing. A guess, on which nothing rests: a
/// fraction of denominator at most 64 and numerator at most 10 000, or the root of one, so near above the ratio that
/// this happens by chance to about one in a thousand ratios between 0 and 1.
[[nodiscard]] std::string ratio_guess(const DoubleBounds& ratio);

}  // namespace delcert
