#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "proofs/formula/step.hpp"

namespace delcert {

/// A step as a file of Coq: a lemma about all real numbers in the ranges of its parameters, and its proof.
struct StepLemma {
  enum class Method : unsigned char {
    certificate,  ///< each comparison by a certificate that Coq only has to check
    search,       ///< by tactics that search: nra, coq-interval's interval
    refutation    ///< not the step is proved but that it is false, by the prover's counterexample
  };
  std::string file;
  Method method = Method::certificate;
};

/// Precondition: `name` is a name in Coq. Nothing if the step has no counterpart in Coq (a quantifier).
/// A step without a certificate is given to the prover for a counterexample.
[[nodiscard]] std::optional<StepLemma> step_lemma(const Step& step, const std::map<std::string, Rational>& constants,
                                                  const std::string& name);

/// "certificate", "search", "refutation".
[[nodiscard]] std::string_view name_of(StepLemma::Method method);

}  // namespace delcert
