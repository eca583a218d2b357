#pragma once

#include <vector>

#include "kernel/manifold/quotient/invariant_form.hpp"
#include "kernel/topology/abelian_group.hpp"

namespace delcert {

/// A finite group of isometries of 𝕊ᵐ, all of it.
struct FiniteGroup {
  /// The identity first.
  std::vector<FieldMatrix> elements;
  /// Γ made abelian: H₁ of 𝕊ᵐ/Γ for m ≥ 2 if Γ acts freely.
  AbelianGroup abelianisation;
};

/// The group that isometries generate: its closure under products, by walking its Cayley graph. The loops of the graph
/// (Schreier's generators) are the relations. Throws Rejection if there are more than `greatest_order` elements: the
/// group is infinite, or larger than that. Precondition: the generators preserve the form.
[[nodiscard]] FiniteGroup closure(const InvariantForm& form, const std::vector<FieldMatrix>& generators,
                                  std::size_t greatest_order);

/// Throws Rejection, naming the element, unless the group acts freely on 𝕊ᵐ: no element but the identity has the
/// eigenvalue 1, det(γ − 1) ≠ 0. Then 𝕊ᵐ/Γ is a manifold.
void require_free(const FiniteGroup& group);

}  // namespace delcert
