#pragma once

#include "kernel/simplex/sphere_form.hpp"

namespace delcert {

// An m-simplex by polynomials in its edges, for doubles with a bound of their errors, as in sphere_form.hpp: S is
// double, or RoundingBound for that bound (docs/rounded-spheres.md).

[[nodiscard]] inline double greater_of(double a, double b) { return a < b ? b : a; }
/// Of the greater of two quantities, whichever that is: it is wrong by no more than one of them.
[[nodiscard]] inline RoundingBound greater_of(const RoundingBound& a, const RoundingBound& b) {
  return RoundingBound::of(greater_of(a.largest(), b.largest()), greater_of(a.error(), b.error()));
}

/// A simplex 0, e₁, …, e_m. With D = det(e₁, …, e_m) its circumsphere has the weight |D|. (m·thickness)² is D²/breadth.
template <class S, int m>
struct SimplexForm {
  SphereForm<S, m> sphere;
  S breadth{};  ///< the greatest squared edge times the greatest squared norm of a facet's covector

  /// `squared`: the squared norms of the edges. 2 ≤ m ≤ 3.
  SimplexForm(const std::array<Vector<S, m>, static_cast<std::size_t>(m)>& edges, const Vector<S, m>& squared) {
    // ⟨ν_k, e_j⟩ = D for j = k, otherwise 0; the facet that 0 is not on has the covector Σ ν_k.
    std::array<Vector<S, m>, static_cast<std::size_t>(m)> covectors;
    for (std::size_t k = 0; k < m; ++k) covectors[k] = covector_without(edges, k);
    Vector<S, m> last = covectors[0];
    for (std::size_t k = 1; k < m; ++k) last = sum(last, covectors[k]);
    S greatest = pairing(last, last);
    for (const auto& covector : covectors) greatest = greater_of(greatest, pairing(covector, covector));
    S longest = squared[0];
    for (std::size_t k = 1; k < m; ++k) {
      longest = greater_of(longest, squared[k]);
      for (std::size_t j = 0; j < k; ++j) {
        const auto side = difference(edges[k], edges[j]);
        longest = greater_of(longest, pairing(side, side));
      }
    }
    breadth = longest * greatest;
    const S determinant = pairing(covectors[0], edges[0]);
    // |e_k|² = 2⟨C, e_k⟩ for the circumcentre C = Σ |e_k|²ν_k / 2D.
    sphere.normal = scaled(squared[0], covectors[0]);
    for (std::size_t k = 1; k < m; ++k) sphere.normal = sum(sphere.normal, scaled(squared[k], covectors[k]));
    if (is_negative(determinant)) {
      for (S& coordinate : sphere.normal) coordinate = -coordinate;
    }
    sphere.weight = absolute(determinant);
    sphere.norm = norm(sphere.normal);
  }

 private:
  /// ν with ⟨ν, x⟩ = det(e₁, …, e_m) with x in the place of e_k.
  static Vector<S, m> covector_without(const std::array<Vector<S, m>, static_cast<std::size_t>(m)>& edges,
                                       std::size_t k) {
    static_assert(m == 2 || m == 3);
    std::array<Vector<S, m>, static_cast<std::size_t>(m)> others{};  // the last entry is not read
    for (std::size_t at = 0; at + 1 < m; ++at) others[at] = edges[(k + 1 + at) % m];
    auto result = wedge(others);
    // To turn m − 1 places around changes the sign of a determinant for even m.
    if (m == 2 && k == 1) {
      for (S& coordinate : result) coordinate = -coordinate;
    }
    return result;
  }
};

}  // namespace delcert
