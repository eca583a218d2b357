#pragma once

#include <string>
#include <vector>

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/number/verdict.hpp"

namespace delcert {

/// One clause of Hypotheses 1 (hyps:input), or of what the perturbation needs of the net.
struct InputItem {
  std::string name;
  Verdict verdict = Verdict::undecided;
  std::string detail;  ///< the values that were compared
};

/// Checks Hypotheses 1 item by item for the patches U_i = B(p_i, bε_i), b = 9(1 + ε₀), of a flat atlas, with the values
/// that decide each. The net's separation, density and ε₀ are those measured before; everything else is decided here,
/// exactly.
template <int m>
[[nodiscard]] std::vector<InputItem> check_input(const FlatAtlas<m>& atlas, const Rational& separation,
                                                 const Rational& perturbation);

}  // namespace delcert
