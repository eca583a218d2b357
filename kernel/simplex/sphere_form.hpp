#pragma once

#include "kernel/number/rounding_bound.hpp"
#include "kernel/number/verdict.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

// Diametric spheres without quotients: every quantity here is a polynomial in Cartesian coordinates, or the norm of
// polynomials, so its rounding errors have a bound that depends on the size of the coordinates only. S is double, or
// RoundingBound for that bound (docs/rounded-spheres.md).

/// The diametric sphere of a simplex v0 … vk, relative to v0, times a weight w.
template <class S, int m>
struct SphereForm {
  Vector<S, m> normal{};  ///< 2w·C, C the centre
  S weight{};             ///< w: above 0 unless the simplex is degenerate
  S norm{};               ///< 2w·R, R the radius

  /// w times the power of v0 + y: w|y|² − ⟨normal, y⟩.
  [[nodiscard]] [[gnu::always_inline]] S power(const Vector<S, m>& y, const S& squared_norm) const {
    return weight * squared_norm - pairing(normal, y);
  }
};

/// Of a point, with the weight 1.
template <class S, int m>
[[nodiscard]] SphereForm<S, m> point_form() {
  SphereForm<S, m> result;
  result.weight = S(1);
  return result;
}

/// Of an edge e, with the weight 1.
template <class S, int m>
[[nodiscard]] SphereForm<S, m> edge_form(const Vector<S, m>& edge) {
  return {edge, S(1), norm(edge)};
}

/// Of the triangle 0ab; the weight is the Gram determinant |a|²|b|² − ⟨a, b⟩².
template <class S, int m>
[[nodiscard]] [[gnu::always_inline]] inline SphereForm<S, m> triangle_form(const Vector<S, m>& a, const S& squared_a,
                                                                           const Vector<S, m>& b, const S& squared_b) {
  const S product = pairing(a, b);
  SphereForm<S, m> result;
  result.weight = squared_a * squared_b - product * product;
  result.normal = sum(scaled(S(squared_b * (squared_a - product)), a), scaled(S(squared_a * (squared_b - product)), b));
  result.norm = norm(result.normal);
  return result;
}

/// A simplex of dimension m − 1 below apexes.
template <class S, int m>
struct FacetForm {
  SphereForm<S, m> sphere;
  Vector<S, m> covector{};  ///< normal to the facet
  S covector_norm{};

  /// `edges`: those of the facet; the last entry is not read.
  FacetForm(const SphereForm<S, m>& form, const std::array<Vector<S, m>, static_cast<std::size_t>(m)>& edges)
      : sphere(form), covector(wedge(edges)), covector_norm(norm(covector)) {}
};

/// The m-simplex over a facet with the apex v0 + e. Its form has the weight |slope|·w, w that of the facet.
template <class S>
struct ApexForm {
  S slope{};  ///< of the apex, by the covector of the facet; 0 for a degenerate simplex
  S lift{};   ///< w times the power of the apex with respect to the facet
  S weight{};

  template <int m>
  [[gnu::always_inline]] ApexForm(const FacetForm<S, m>& facet, const Vector<S, m>& edge, const S& squared_edge)
      : slope(pairing(facet.covector, edge)),
        lift(facet.sphere.power(edge, squared_edge)),
        weight(absolute(slope) * facet.sphere.weight) {}

  /// Of the form. It has a root, which what is far away is decided about without.
  template <int m>
  [[nodiscard]] [[gnu::always_inline]] S norm(const FacetForm<S, m>& facet) const {
    return delcert::norm(std::array<S, 2>{slope * facet.sphere.norm, lift * facet.covector_norm});
  }

  /// What a point y has to do with the facet: w times its power, and its slope.
  struct Probe {
    S power{};
    S slope{};
  };
  template <int m>
  [[nodiscard]] static Probe probe(const FacetForm<S, m>& facet, const Vector<S, m>& y, const S& squared_norm) {
    return {facet.sphere.power(y, squared_norm), pairing(facet.covector, y)};
  }
  /// The weight of this form times the power of the point, with the sign of the slope.
  [[nodiscard]] [[gnu::always_inline]] S signed_power(const Probe& probe) const {
    return slope * probe.power - lift * probe.slope;
  }
  /// As a form of its own.
  template <int m>
  [[nodiscard]] [[gnu::always_inline]] SphereForm<S, m> form(const FacetForm<S, m>& facet) const {
    auto normal = sum(scaled(slope, facet.sphere.normal), scaled(lift, facet.covector));
    if (is_negative(slope)) {
      for (S& coordinate : normal) coordinate = -coordinate;
    }
    return {normal, weight, norm(facet)};
  }
};

/// Above 0 only for points that are farther than t from the sphere, whatever its radius R below ϱ is: w(|P| − t(2ϱ +
/// t)). For |d − R| ≤ t at the distance d from the centre gives |P| = |d − R|(d + R) ≤ t(2R + t). `power` is w·P or
/// −w·P.
template <class S>
[[nodiscard]] [[gnu::always_inline]] inline S certain_gap(const S& power, const S& weight, const S& t,
                                                          const S& radius) {
  return absolute(power) - (t * (radius + radius + t)) * weight;
}

/// How far beyond a length t a point is from a sphere, in three quantities: farther exactly if `outer` is above 0, or
/// `inner` and `room` both are.
template <class S>
struct SphereGap {
  S outer{};  ///< w(P − t² − 2tR): above 0 farther than t outside
  S inner{};  ///< w(t² − 2tR − P): above 0 farther than t inside, if there is room
  S room{};   ///< 2w(R − t)

  /// From w·P, 2wR and w.
  [[gnu::always_inline]] SphereGap(const S& power, const S& norm, const S& weight, const S& t)
      : outer(power - t * (norm + t * weight)), inner(t * (t * weight - norm) - power), room(norm - (t + t) * weight) {}
};

/// Whether the point is farther, if the three quantities are wrong by no more than these bounds say.
[[nodiscard]] [[gnu::always_inline]] inline Verdict is_farther(const SphereGap<double>& gap,
                                                               const SphereGap<RoundingBound>& bound) {
  if (gap.outer > bound.outer.error()) return Verdict::proved;
  if (gap.inner > bound.inner.error() && gap.room > bound.room.error()) return Verdict::proved;
  if (gap.outer < -bound.outer.error() && (gap.inner < -bound.inner.error() || gap.room < -bound.room.error()))
    return Verdict::refuted;
  return Verdict::undecided;
}

}  // namespace delcert
