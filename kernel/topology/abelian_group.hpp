#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// A finitely generated abelian group up to isomorphism: ℤ^r ⊕ ℤ/d₁ ⊕ … ⊕ ℤ/d_s with 1 < d₁ | d₂ | … | d_s.
struct AbelianGroup {
  std::size_t free_rank = 0;
  std::vector<Integer> torsion;  ///< d₁ … d_s

  friend bool operator==(const AbelianGroup&, const AbelianGroup&) = default;
};

/// "0", "Z", "Z^4", "Z + Z/2", "(Z/5)^3", "Z^2 + Z/2 + (Z/4)^2": one text for each group, as certificates have it.
[[nodiscard]] std::string group_text(const AbelianGroup& group);

/// Whether this is the `group_text` of some group.
[[nodiscard]] bool is_group_text(const std::string& text);

/// ℤⁿ modulo the relations, each with n = `generators` coefficients: by the Smith normal form.
[[nodiscard]] AbelianGroup abelian_group(std::size_t generators,
                                         const std::vector<std::vector<std::int64_t>>& relations);

}  // namespace delcert
