#include "properties/instances/run_vocabulary.hpp"

#include "kernel/simplex/thickness.hpp"
#include "proofs/formula/evaluation.hpp"
#include "properties/instances/run_object.hpp"

namespace delcert {

namespace {

template <class S>
const RunObject& run_of(const Argument<S>& argument) {
  return object_of<RunObject>(argument);
}

/// Something between two bounds; nothing on rungs that know numbers exactly.
template <class S>
Partial<S> between(const Rational& lower, const Rational& upper) {
  if constexpr (std::same_as<S, Interval>) {
    return Interval::between(scalar_from<Interval>(lower).lower(), scalar_from<Interval>(upper).upper());
  } else if constexpr (std::same_as<S, BigInterval>) {
    return BigInterval::between(lower, upper);
  } else {
    return Partial<S>::absent(Verdict::undecided);
  }
}

template <class S>
Partial<S> least_thickness(const RunObject& run) {
  std::optional<S> least;
  const auto count = static_cast<std::size_t>(run.dimension()) + 1;
  for (const auto& edges : run.squared_edges()) {
    SymmetricMatrix<S> squared(count);
    auto edge = edges.begin();
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) squared(j, i) = scalar_from<S>(*edge++);
    }
    Partial<S> here = thickness(edge_gram_from_squared_edges(std::move(squared)));
    if (!here) return here;
    least = least ? minimum(*least, *here) : *here;
  }
  return least ? Partial<S>(*least) : Partial<S>::absent(Verdict::refuted);
}

/// Proved where a level was reached. Not to reach it refutes nothing, but a simplex that is not protected does.
Verdict reached(const RunObject& run, bool level) {
  if (is_refuted(run.stars())) return Verdict::refuted;
  return is_proved(run.stars()) && level ? Verdict::proved : Verdict::undecided;
}

/// A verdict of a run that is the same on every rung.
template <class F>
Function run_statement(std::string name, std::string meaning, std::string latex, const F& verdict) {
  return truth_function(std::move(name), {types::run}, std::move(meaning), std::move(latex),
                        [verdict]<class S>(Evaluation<S>&, Arguments<S> a) { return verdict(run_of(a[0])); });
}

void add_statements(Vocabulary& vocabulary) {
  vocabulary.add(run_statement("satisfies_hypotheses",
                               "Hypotheses 1 and 2 hold, decided item by item, and the points are those that the "
                               "algorithm perturbed with the paper's constants.",
                               "#1\\text{ satisfies Hypotheses 1, 2}",
                               [](const RunObject& run) { return run.hypotheses(); }));
  vocabulary.add(run_statement("has_no_forbidden_configuration",
                               "No simplex on the perturbed points of a run has all of P1 to P4 for the paper's "
                               "constants, by exhaustive search.",
                               "#1\\text{ has no forbidden configuration}",
                               [](const RunObject& run) { return run.no_forbidden(); }));
  vocabulary.add(run_statement("has_protected_stars",
                               "Every simplex of every star of a run is certified to be protected, and the stars to "
                               "be closed; refuted by a simplex with another point on or in its sphere.",
                               "\\operatorname{star}(#1)\\text{ protected}",
                               [](const RunObject& run) { return run.stars(); }));
  vocabulary.add(run_statement("is_manifold",
                               "The stars of a run agree and make a closed manifold complex (level 2 of certificates).",
                               "#1\\text{ is a manifold complex}",
                               [](const RunObject& run) { return reached(run, run.claims().manifold.has_value()); }));
  vocabulary.add(
      run_statement("has_stable_stars", "Each star of a run is the same in the charts of all its vertices (level 2s).",
                    "\\operatorname{star}(#1)\\text{ stable}",
                    [](const RunObject& run) { return reached(run, run.claims().stable_stars.has_value()); }));
  vocabulary.add(run_statement(
      "is_delaunay", "The complex of a run is the Delaunay complex of its points in the manifold (level 4).",
      "#1 = \\mathrm{Del}", [](const RunObject& run) { return reached(run, run.claims().delaunay.has_value()); }));
  vocabulary.add(run_statement(
      "is_triangulation", "The complex of a run is homeomorphic to the manifold by straight simplices (level 5).",
      "\\lvert #1\\rvert \\cong \\mathcal M",
      [](const RunObject& run) { return reached(run, run.claims().triangulation.has_value()); }));
  vocabulary.add(run_statement(
      "is_self_delaunay", "The complex of a run is isometric to the manifold and self-Delaunay (level 6).",
      "#1\\text{ self-Delaunay}", [](const RunObject& run) { return reached(run, run.claims().metric.has_value()); }));
}

void add_numbers(Vocabulary& vocabulary) {
  vocabulary.add(number_function(
      "least_protection", {types::run},
      "The least protection of the simplices of a run, a length; enclosed to 11 binary digits, from half a sampling "
      "radius on only between what is certified and twice the covering radius; undefined without certified stars.",
      "\\delta(#1)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        const RunObject& run = run_of(a[0]);
        if (!run.claims().stars) return Partial<S>::absent(Verdict::undecided);
        const Rational& lower = run.claims().stars->protection;
        const Rational upper = lower * (Rational(1) + Rational::power_of_two(-10));
        if (Rational(2) * upper < run.sampling_radius()) return between<S>(lower, upper);
        // The certified number is not searched for beyond. If σ is δ-protected, δ > cov, take x at the distance
        // R + δ − cov from C(σ): what is within cov of x can only be a vertex of σ, at least δ − cov away.
        return between<S>(lower, Rational(2) * run.covering_upper());
      }));
  vocabulary.add(number_function(
      "least_thickness", {types::run}, "The least thickness of the simplices of a run.", "\\Upsilon(#1)",
      []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> { return least_thickness<S>(run_of(a[0])); }));
  vocabulary.add(number_function(
      "perturbed_covering_radius", {types::run},
      "The covering radius of the perturbed points of a run, a length; enclosed by a certified triangulation.",
      "\\operatorname{cov}(#1)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        return between<S>(run_of(a[0]).covering_lower(), run_of(a[0]).covering_upper());
      }));
  vocabulary.add(number_function(
      "perturbed_separation", {types::run},
      "The least distance of the perturbed points of a run, at most a sampling radius, a length; enclosed to 19 binary "
      "digits of the sampling radius.",
      "\\operatorname{sep}(#1)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        return between<S>(run_of(a[0]).distance_lower(), run_of(a[0]).distance_upper());
      }));
  vocabulary.add(number_function("euler_characteristic", {types::run},
                                 "Of the complex of a run, where it is certified to be a manifold.", "\\chi(#1)",
                                 []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                   const auto& manifold = run_of(a[0]).claims().manifold;
                                   if (!manifold) return Partial<S>::absent(reached(run_of(a[0]), false));
                                   return scalar_from<S>(Rational(manifold->euler_characteristic));
                                 }));
}

}  // namespace

void add_run_quantities(Vocabulary& vocabulary) {
  vocabulary.add_kind("run", RunObject::read);
  add_statements(vocabulary);
  add_numbers(vocabulary);
}

}  // namespace delcert
