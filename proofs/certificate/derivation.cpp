#include "proofs/certificate/derivation.hpp"

#include <algorithm>

#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {

bool Derivation::balls_fit(const char* level, const Rational& circumradius, const Rational& protection) const {
  if (lies_within(shift + Rational(2) * circumradius + protection)) return true;
  reasons.push_back(std::string("level ") + level + ": a circumball with its protection does not fit into a patch");
  return false;
}

bool Derivation::derive_margins(const LocalMargins& found) {
  if (!selects("1") && !selects("2")) return false;
  const StarMargins margins{stated_below(found.protection), stated_below(found.thickness),
                            stated_above(found.circumradius)};
  if (!balls_fit("1", margins.circumradius, margins.protection)) return false;
  claims.stars = margins;
  return true;
}

void Derivation::derive_stability(const StarStability& stability, double own_reach) {
  if (!selects("2s") || !claims.manifold) return;
  if (stability.differing > 0) {
    reasons.push_back("level 2s: " + std::to_string(stability.stars) +
                      " stars are not certified to be the same in all charts (" + std::to_string(stability.differing) +
                      " of " + std::to_string(stability.pairs) + " pairs)" +
                      (stability.occupied == 0 ? ""
                                               : "; of " + std::to_string(stability.occupied) +
                                                     " a simplex has another point in its ball in such a chart"));
    return;
  }
  const Rational reach = stated_above(std::max(own_reach, stability.margins.reach));
  if (lies_within(reach)) {
    claims.stable_stars = StableStarsClaim{reach};
  } else {
    reasons.emplace_back("level 2s: a star does not fit into the patches of its vertices");
  }
}

void Derivation::widen_reach() {
  if (!claims.stable_stars || !claims.stars) return;
  const Rational enough = Rational(4) * claims.stars->circumradius + shift;
  if (lies_within(enough)) claims.stable_stars->reach = maximum(*claims.stable_stars->reach, enough);
}

}  // namespace delcert
