#pragma once

#include <vector>

#include "kernel/chart/atlas.hpp"
#include "support/progress.hpp"

namespace delcert {

/// A colour for each label of an atlas, 0, 1, …, such that no label sights another one of its colour within `reach`
/// sampling radii of its own: what is done for one and looks no farther than that does not see what is done for the
/// other. Greedy: each label in turn gets the least colour that none of the labels before it has that sight it or that
/// it sights. Depends on the atlas and the reach only. Preconditions: those of `Atlas::sightings`, for a reach that is
/// greater by a relative 2⁻³⁰; rounding to nearest.
template <int m>
[[nodiscard]] std::vector<std::uint32_t> colours_of(const Atlas<m>& atlas, const Rational& reach,
                                                    const Progress& progress);

/// The same where the first labels have their colours already: these, and those of the labels that follow, up to
/// `end`, not included.
template <int m>
[[nodiscard]] std::vector<std::uint32_t> more_colours_of(const Atlas<m>& atlas, const Rational& reach,
                                                         std::vector<std::uint32_t> known, std::uint32_t end,
                                                         const Progress& progress);

}  // namespace delcert
