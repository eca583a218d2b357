#pragma once

#include <string_view>

#include "kernel/number/rational.hpp"
#include "kernel/number/strong.hpp"
#include "proofs/constants/power_product.hpp"

namespace delcert {

/// The largest dimension of a ledger: the sample size that Theorem 3 asks for already has a million binary digits
/// there.
inline constexpr Dimension largest_ledger_dimension{16};

/// Which form of Hypotheses 2 the constants belong to: the paper's, or the weaker one that the sharper lemmas admit
/// (docs/sharper-lemmas.md): ξ₀ ≤ 2⁻⁴(ρ₀/C)^{2m+2}, C without m^{3/2}, α̃₀ = 17410Γ₀/μ₀³.
enum class ParameterConstraints : unsigned char { printed, sharper };

/// "printed", "sharper": as on the command line and in certificates.
[[nodiscard]] std::string_view name_of(ParameterConstraints constraints);

/// What the paper derives from the dimension m, the separation μ₀, the perturbation ρ₀, the radius variation ε₀ and the
/// distortion ξ₀ of an input. Every value is exact; lengths are relative to the sampling radius ε unless said.
struct Ledger {
  ParameterConstraints constraints = ParameterConstraints::printed;
  Dimension dimension;
  Rational separation;
  Rational perturbation;
  Rational radius_variation;
  Rational distortion;

  /// ρ̃₀ = (1 + ε₀)(1 + ξ₀)ρ₀ (hyps:param.bnds).
  Rational perturbation_tilde;
  /// μ₀′ = (μ₀ − 2ρ̃₀)/(1 + ρ̃₀) and ε′/ε = 1 + ρ̃₀ (lem:loc.eucl.protect).
  Rational perturbed_separation;
  Rational perturbed_radius_ratio;

  /// C = m^{3/2}(2/μ₀)^{4m²+5m+21} (hyps:param.bnds); sharper: without m^{3/2}.
  PowerProduct flake_divisor;
  /// Γ₀ = ρ₀/C (lem:loc.eucl.protect).
  PowerProduct flake_parameter;
  /// δ₀ = Γ₀^{m+1}: Delaunay simplices become δ₀μ₀′ε′-protected (lem:loc.eucl.protect).
  PowerProduct protection_parameter;
  /// δ₀μ₀′ε′/ε = δ₀(μ₀ − 2ρ̃₀), the protection relative to ε (lem:loc.eucl.protect).
  PowerProduct protection;
  /// α₀ = 2¹³Γ₀/μ₀³ (lem:prop.forbid.cfg, P1).
  PowerProduct hoop_bound;
  /// α̃₀ = 2¹⁶m^{3/2}Γ₀/μ₀³ (lem:hoop.distort), sharper: 17410Γ₀/μ₀³. Rational, since m^{3/2} cancels.
  PowerProduct hoop_bound_tilde;
  /// 2α̃₀: a perturbation is good when farther than this from every candidate sphere (def:extended.good.pert). Rational.
  PowerProduct tolerance;
  /// (5/4)δ₀μ₀: the longest edge of a forbidden configuration is shorter than 5/2 and this (lem:prop.forbid.cfg, P3).
  PowerProduct longest_edge_excess;
  /// An upper bound of (5/2)(1 + δ₀μ₀/2), which is 5/2 and that excess; at most 2⁻¹²⁶ above it.
  Rational longest_edge_upper;
  /// (14/μ₀)^{m²+m} > the number of simplices tested for a label (eq:bnd.nbr.cplx).
  PowerProduct candidates_bound;

  /// ε₀ ≤ (1 − ξ₀)/(1 + ξ₀) (hyps:param.bnds).
  Rational radius_variation_bound;
  /// ρ̃₀ ≤ μ₀/4 (hyps:param.bnds).
  Rational perturbation_tilde_bound;
  /// Γ₀ ≤ 2μ₀²/75 (eq:dnobnd).
  Rational flake_parameter_bound;
  /// ξ₀ ≤ 2⁻⁴(ρ₀/C)^{4m+2} (hyps:param.bnds); sharper: 2m + 2. Rational.
  PowerProduct distortion_bound;
  /// ξ₀ ≤ Γ₀^{2m+1}μ₀²/2¹² (lem:stable.stars).
  PowerProduct stable_stars_distortion_bound;
  /// ξ₀ ≤ (Γ₀^{2m+1}/4)² (lem:hoop.distort); sharper: m + 1. Rational.
  PowerProduct hoop_distortion_bound;
  /// η ≤ (μ₀²/2¹²)(ρ₀/C)^{2m+1} (thm:output.del.cplx).
  PowerProduct metric_distortion_bound;

  /// ε_i ≤ Γ₀^{2m+1}/2⁶, the bound (eq:locsam.curv.bnd) under exponential charts of a manifold whose sectional
  /// curvatures are within [−1, 1]; sharper: Γ₀^{m+1}/2⁵. A length on the manifold.
  PowerProduct chart_sampling_radius;
  /// Theorem 3 asks for ρ₀ ≤ μ₀/5: the smaller of ρ₀ and μ₀/5.
  Rational riemannian_perturbation;
  /// C̃ = m^{3/2}(2/μ₀)^{5m²+5m+21} (thm:riem.del.tri); sharper (docs/claims/riemannian-constants.md): C, as above.
  PowerProduct riemannian_flake_divisor;
  /// The riemannian_perturbation divided by C̃.
  PowerProduct riemannian_flake_parameter;
  /// ε ≤ 2⁻⁶(ρ₀/C̃)^{2m+1} at the riemannian_perturbation (thm:riem.del.tri), for sectional curvatures within [−1, 1];
  /// sharper: 2⁻⁵(ρ₀/C)^{m+1};
  /// the other bound of Theorem 3, a quarter of the injectivity radius, is not in it. A length on the manifold.
  PowerProduct riemannian_sampling_radius;
  /// 2⁻⁵(ρ₀/C)^{2m+1}, for which the sharper Theorem 3 says that the piecewise flat metric is self-Delaunay; of the
  /// printed one the radius above. A length on the manifold.
  PowerProduct self_delaunay_sampling_radius;
  /// 2⁸(C̃/ρ₀)^{2m}ε² at the riemannian_sampling_radius: how much the piecewise flat metric differs from the
  /// manifold's, relatively (thm:riem.del.tri); sharper: 320(C/ρ₀)^{2m}ε².
  PowerProduct piecewise_flat_distortion;
};

/// μ₀/(4(1 + ε₀)(1 + ξ₀)), the largest ρ₀ for which ρ̃₀ ≤ μ₀/4; μ₀/4 where ε₀ or ξ₀ is negative.
[[nodiscard]] Rational largest_perturbation(const Rational& separation, const Rational& radius_variation,
                                            const Rational& distortion);

/// The ledger of the paper, or of the sharper lemmas. Throws InputError, naming the parameter, its value and its range,
/// unless 1 ≤ m ≤ largest_ledger_dimension, 0 < μ₀ ≤ 1, 0 ≤ ξ₀ < 1, 0 ≤ ε₀ ≤ (1 − ξ₀)/(1 + ξ₀), 0 < ρ₀ and ρ̃₀ ≤ μ₀/4.
[[nodiscard]] Ledger constants_for(Dimension dimension, const Rational& separation, const Rational& perturbation,
                                   const Rational& radius_variation = Rational(0),
                                   const Rational& distortion = Rational(0),
                                   ParameterConstraints constraints = ParameterConstraints::printed);

/// Whether Hypotheses 2 hold (hyps:param.bnds): beyond what constants_for requires, ξ₀ ≤ distortion_bound.
[[nodiscard]] bool satisfies_parameter_constraints(const Ledger& ledger);

}  // namespace delcert
