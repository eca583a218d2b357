#include "proofs/certificate/stability_claim.hpp"

#include <algorithm>

#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {

std::optional<Rational> derive_reach(const StarStability& stability, double own_reach,
                                     const std::function<bool(const Rational&)>& fits,
                                     std::vector<std::string>& reasons) {
  if (stability.differing > 0) {
    reasons.push_back("level 2s: " + std::to_string(stability.stars) +
                      " stars are not certified to be the same in all charts (" + std::to_string(stability.differing) +
                      " of " + std::to_string(stability.pairs) + " pairs)");
    return {};
  }
  const Rational reach = stated_above(std::max(own_reach, stability.margins.reach));
  if (fits(reach)) return reach;
  reasons.emplace_back("level 2s: a star does not fit into the patches of its vertices");
  return {};
}

}  // namespace delcert
