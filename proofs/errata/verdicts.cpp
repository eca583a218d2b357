#include "proofs/errata/verdicts.hpp"

#include <fmt/format.h>

namespace delcert {

const std::vector<TheoremVerdict>& theorem_verdicts() {
  static const std::vector<TheoremVerdict> list{
      {"Theorem 1", "thm:man.mesh",
       "Needs hypotheses. For separations μ₀ > 1 it can fail: on a torus with a hexagonal net, m = 2 and 1.61 ≤ μ₀ < "
       "√3, "
       "no perturbation of the first point is good, and the algorithm does not end. For μ₀ ≤ 1 no counterexample is "
       "known; the proof uses more of the input than Hypotheses 1 say.",
       "True under Hypotheses 1′ and 2: μ₀ ≤ 1; radii compared and transitions given for all neighbours in 𝒩_i; "
       "domains "
       "up to 25/4 ε_i for 6ε_i; the condition on labels of section 3.2; transitions that agree on threefold overlaps.",
       "Those of Hypotheses 2, as printed. The printed test of m-simplices suffices, and a random perturbation is good "
       "with probability at least 19/20.",
       "[hypotheses.md](claims/hypotheses.md), [printed-algorithm.md](claims/printed-algorithm.md), "
       "[termination.md](claims/termination.md), [theorems.md](claims/theorems.md): complete, nothing is quoted from "
       "the "
       "earlier papers."},
      {"Theorem 2", "thm:output.del.cplx",
       "False for metrics with shortcuts: the command of its entry below finds, on a torus, an edge of the Delaunay "
       "complex that the output does not have.",
       "True under Hypotheses 1′ and 2 if every component of M has a point of P, 𝒩_i has the labels of all points of P "
       "within 6ε_i, and far points are far: d_M(x, y) ≥ 2ε_i for x in the preimage of B(p_i, 3ε_i) and y "
       "outside of that of B(p_i, 6ε_i). Every metric given by lengths of curves has the last property.",
       "η as printed; 2⁵ for its 2¹² suffices, and 2⁵ for the 2¹² of lem:stable.stars too.",
       "[theorems.md](claims/theorems.md): complete, without the quoted stability theorem."},
      {"Theorem 3", "thm:riem.del.tri",
       "One constant of its proof does not hold: charts on balls of radius 10ε need inj/20 for inj/4. No "
       "counterexample "
       "to its conclusion is known.",
       "True, given the theorems that are quoted, for m ≥ 2, M compact and μ₀ ≤ 1, and for m = 1, where all charts are "
       "isometries.",
       "inj/20 for inj/4. All others as printed: C̃, ρ₀ ≤ μ₀/5, 2⁶ in the bound of ε and 2⁸ in that of the metric.",
       "[riemannian-constants.md](claims/riemannian-constants.md). It quotes Rauch's theorem, Whitehead's on convex "
       "balls, "
       "and the triangulation theorem of Dyer, Vegter and Wintraecken with the conditions that the paper prints."},
  };
  return list;
}

std::string verdicts_markdown() {
  std::string text = "\n## Verdicts\n";
  for (const TheoremVerdict& verdict : theorem_verdicts())
    text += fmt::format("\n### {} ({})\n\n* *As printed.* {}\n* *Hypotheses.* {}\n* *Constants.* {}\n* *Proof.* {}\n",
                        verdict.number, verdict.label, verdict.as_printed, verdict.hypotheses, verdict.constants,
                        verdict.proof);
  return text;
}

}  // namespace delcert
