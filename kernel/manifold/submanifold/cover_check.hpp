#pragma once

#include <cstdint>
#include <vector>

#include "kernel/manifold/submanifold/tangent_chart.hpp"
#include "support/progress.hpp"

namespace delcert {

/// A part of the box, N coordinates each.
struct BoxPart {
  std::vector<double> lower;
  std::vector<double> upper;
};

struct CoverReport {
  std::uint64_t parts = 0;  ///< looked at
  /// Parts that are neither shown to be without zeros nor inside of a cylinder: some of them, as there may be
  /// very many. None: sub.cover holds.
  std::vector<BoxPart> open;
};

/// Rule sub.cover of docs/submanifolds.md: the box is divided until each part certainly has no zero of the equations –
/// some combination of them is bounded away from 0 by the mean-value form – or lies in the open cylinder of some chart.
/// Then M is what the patches are. Parts are divided to an eighth of the least height of a cylinder, and no more than
/// 2¹⁸ times each of some 1000 pieces of the box: it always ends. Precondition: rounding to nearest; charts have their
/// sizes.
[[nodiscard]] CoverReport check_cover(const ZeroSet& zero_set, const std::vector<TangentChart>& charts,
                                      const Progress& progress);

}  // namespace delcert
