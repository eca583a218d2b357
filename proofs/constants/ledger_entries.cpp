#include "proofs/constants/ledger_entries.hpp"

#include "kernel/number/exact_text.hpp"
#include "proofs/constants/sphere_sample_size.hpp"

namespace delcert {

namespace {

struct Heading {
  const char* name;
  const char* symbol;
  const char* latex_symbol;
  const char* source;
};

std::string fraction_latex(const Rational& x) {
  if (x.denominator() == 1) return x.numerator().str();
  const bool negative = x < Rational(0);
  const Rational size = absolute(x);
  return std::string(negative ? "-" : "") + "\\frac{" + size.numerator().str() + "}{" + size.denominator().str() + "}";
}

LedgerEntry entry(const Heading& heading, std::string exact, std::string exact_latex, Bounds value,
                  std::optional<Bounds> log2) {
  return {.name = heading.name,
          .symbol = heading.symbol,
          .latex_symbol = heading.latex_symbol,
          .exact = std::move(exact),
          .exact_latex = std::move(exact_latex),
          .value = std::move(value),
          .log2 = std::move(log2),
          .source = heading.source,
          .is_estimate = false};
}

LedgerEntry entry(const Heading& heading, const PowerProduct& x) {
  Bounds value = x.bounds();
  if (x.is_rational()) value = {x.rational(), x.rational()};
  return entry(heading, x.text(), x.latex(), value, x.log2());
}

LedgerEntry entry(const Heading& heading, const Rational& x) {
  std::optional<Bounds> log2;
  if (x > Rational(0)) log2 = PowerProduct(x).log2();
  return entry(heading, exact_text(x), fraction_latex(x), {x, x}, log2);
}

LedgerEntry entry(const Heading& heading, const Bounds& value) { return entry(heading, "", "", value, std::nullopt); }

/// 5/2 and its excess, the latter from 256 bits.
Bounds longest_edge_bounds(const Ledger& ledger) {
  const Rational least = Rational(5) / Rational(2);
  const Bounds excess = ledger.longest_edge_excess.bounds();
  return {least + excess.lower, least + excess.upper};
}

}  // namespace

std::vector<LedgerEntry> ledger_entries(const Ledger& ledger) {
  const bool is_sharper = ledger.constraints == ParameterConstraints::sharper;
  const auto source = [is_sharper](const char* printed) { return is_sharper ? "sharper-lemmas" : printed; };
  std::vector<LedgerEntry> entries{
      entry({"dimension", "m", "m", "input"}, Rational(ledger.dimension.value)),
      entry({"separation", "μ₀", "\\mu_0", "input"}, ledger.separation),
      entry({"perturbation", "ρ₀", "\\rho_0", "input"}, ledger.perturbation),
      entry({"radius_variation", "ε₀", "\\epsilon_0", "input"}, ledger.radius_variation),
      entry({"distortion", "ξ₀", "\\xi_0", "input"}, ledger.distortion),
      entry({"perturbation_tilde", "ρ̃₀", "\\tilde\\rho_0", "hyps:param.bnds"}, ledger.perturbation_tilde),
      entry({"perturbed_separation", "μ₀′", "\\mu_0'", "lem:loc.eucl.protect"}, ledger.perturbed_separation),
      entry({"perturbed_radius_ratio", "ε′/ε", "\\epsilon'/\\epsilon", "lem:loc.eucl.protect"},
            ledger.perturbed_radius_ratio),
      entry({"flake_divisor", "C", "C", source("hyps:param.bnds")}, ledger.flake_divisor),
      entry({"flake_parameter", "Γ₀", "\\Gamma_0", "lem:loc.eucl.protect"}, ledger.flake_parameter),
      entry({"flake_parameter_squared", "Γ₀²", "\\Gamma_0^2", "lem:loc.eucl.protect"},
            power(ledger.flake_parameter, 2)),
      entry({"protection_parameter", "δ₀", "\\delta_0", "lem:loc.eucl.protect"}, ledger.protection_parameter),
      entry({"protection_parameter_squared", "δ₀²", "\\delta_0^2", "lem:loc.eucl.protect"},
            power(ledger.protection_parameter, 2)),
      entry({"protection", "δ/ε", "\\delta/\\epsilon", "lem:loc.eucl.protect"}, ledger.protection),
      entry({"hoop_bound", "α₀", "\\alpha_0", "lem:prop.forbid.cfg"}, ledger.hoop_bound),
      entry({"hoop_bound_squared", "α₀²", "\\alpha_0^2", "lem:prop.forbid.cfg"}, power(ledger.hoop_bound, 2)),
      entry({"hoop_bound_tilde", "α̃₀", "\\tilde\\alpha_0", source("lem:hoop.distort")}, ledger.hoop_bound_tilde),
      entry({"tolerance", "2α̃₀", "2\\tilde\\alpha_0", "def:extended.good.pert"}, ledger.tolerance),
      entry({"longest_edge", "(5/2)(1+δ₀μ₀/2)", "\\frac52(1+\\frac12\\delta_0\\mu_0)", "lem:prop.forbid.cfg"},
            "5/2 + " + ledger.longest_edge_excess.text(), "\\frac{5}{2} + " + ledger.longest_edge_excess.latex(),
            longest_edge_bounds(ledger), std::nullopt),
      entry({"candidates_bound", "|S_i| <", "|\\mathcal{S}_i| <", "eq:bnd.nbr.cplx"}, ledger.candidates_bound),
      entry({"radius_variation_bound", "ε₀ ≤", "\\epsilon_0 \\le", "hyps:param.bnds"}, ledger.radius_variation_bound),
      entry({"perturbation_tilde_bound", "ρ̃₀ ≤", "\\tilde\\rho_0 \\le", "hyps:param.bnds"},
            ledger.perturbation_tilde_bound),
      entry({"flake_parameter_bound", "Γ₀ ≤", "\\Gamma_0 \\le", "eq:dnobnd"}, ledger.flake_parameter_bound),
      entry({"distortion_bound", "ξ₀ ≤", "\\xi_0 \\le", source("hyps:param.bnds")}, ledger.distortion_bound),
      entry({"stable_stars_distortion_bound", "ξ₀ ≤", "\\xi_0 \\le", "lem:stable.stars"},
            ledger.stable_stars_distortion_bound),
      entry({"hoop_distortion_bound", "ξ₀ ≤", "\\xi_0 \\le", source("lem:hoop.distort")}, ledger.hoop_distortion_bound),
      entry({"metric_distortion_bound", "η ≤", "\\eta \\le", "thm:output.del.cplx"}, ledger.metric_distortion_bound)};
  const SphereSampleSize sphere = sphere_sample_size(ledger.dimension, ledger.riemannian_sampling_radius);
  const auto theorem_3_source = [is_sharper](const char* printed) {
    return is_sharper ? "riemannian-constants" : printed;
  };
  std::vector<LedgerEntry> theorem_3{
      entry({"chart_sampling_radius", "ε_i ≤ (Λ = 1)", "\\epsilon_i \\le", theorem_3_source("eq:locsam.curv.bnd")},
            ledger.chart_sampling_radius),
      entry({"riemannian_perturbation", "min(ρ₀, μ₀/5)", "\\min(\\rho_0, \\mu_0/5)", "thm:riem.del.tri"},
            ledger.riemannian_perturbation),
      entry({"riemannian_flake_divisor", "C̃", "\\tilde C", theorem_3_source("thm:riem.del.tri")},
            ledger.riemannian_flake_divisor),
      entry({"riemannian_flake_parameter", "ρ₀/C̃", "\\rho_0/\\tilde C", "thm:riem.del.tri"},
            ledger.riemannian_flake_parameter),
      entry({"riemannian_sampling_radius", "ε ≤ (Λ = 1)", "\\epsilon \\le", theorem_3_source("thm:riem.del.tri")},
            ledger.riemannian_sampling_radius),
      entry({"piecewise_flat_distortion", "|d_M/d_PL−1| ≤", "\\lvert d_M/d_{PL} - 1 \\rvert \\le",
             theorem_3_source("thm:riem.del.tri")},
            ledger.piecewise_flat_distortion),
      entry({"sphere_sample_size_at_least", "n ≥ on S^m", "n \\ge", "volume of geodesic balls"},
            (sphere.has_factor_pi ? "π·" : "") + sphere.at_least_without_pi.text(),
            (sphere.has_factor_pi ? "\\pi \\cdot " : "") + sphere.at_least_without_pi.latex(), sphere.at_least,
            sphere.at_least_log2)};
  // The printed theorem has one radius for all that it says.
  if (is_sharper) {
    theorem_3.insert(theorem_3.begin() + 5,
                     entry({"self_delaunay_sampling_radius", "ε ≤ (Λ = 1)", "\\epsilon \\le", "riemannian-constants"},
                           ledger.self_delaunay_sampling_radius));
  }
  entries.insert(entries.end(), theorem_3.begin(), theorem_3.end());
  if (sphere.measured_estimate) {
    entries.push_back(
        entry({"sphere_sample_size_estimate", "n ≈ on S^m", "n \\approx", "measured on Poisson-disk nets"},
              *sphere.measured_estimate));
    entries.back().is_estimate = true;
  }
  return entries;
}

}  // namespace delcert
