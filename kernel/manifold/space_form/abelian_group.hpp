#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// A finitely generated abelian group ℤʳ ⊕ ℤ/d₁ ⊕ … ⊕ ℤ/d_k with d₁ | d₂ | …, 1 < d₁.
struct AbelianGroup {
  std::size_t rank = 0;
  std::vector<Integer> torsion;

  friend bool operator==(const AbelianGroup&, const AbelianGroup&) = default;
};

/// "0", "Z", "Z^4", "Z + Z/2", "(Z/5)^3": as in manifold files.
[[nodiscard]] std::string name_of(const AbelianGroup& group);

/// ℤⁿ modulo the relations, each with n = `generators` coefficients: by Smith's normal form (FLINT).
[[nodiscard]] AbelianGroup abelian_group(std::size_t generators,
                                         const std::vector<std::vector<std::int64_t>>& relations);

}  // namespace delcert
