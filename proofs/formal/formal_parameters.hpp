#pragma once

#include <string>
#include <vector>

#include "proofs/formal/polynomial_text.hpp"
#include "proofs/formula/coq.hpp"
#include "proofs/formula/step.hpp"

namespace delcert {

/// A parameter of a step as the lemma in Coq has it: a real number, also where it is an integer, which says more.
struct FormalParameter {
  std::string name;
  StepRange range;
  bool is_squared = false;  ///< the proof speaks of its root instead, which is called root_<name>

  /// The variable of the polynomials: the parameter or its root.
  [[nodiscard]] std::string variable_name() const;
  /// The parameter itself: its name, or the root times the root.
  [[nodiscard]] std::string text() const;
  /// What is known of the variable. A root of an end that is irrational is rounded outwards.
  [[nodiscard]] FormalVariable variable() const;
};

using FormalParameters = std::vector<FormalParameter>;

/// Of a step, by name.
[[nodiscard]] FormalParameters formal_parameters(const Step& step);

/// How the names of parameters are printed in the proof.
[[nodiscard]] CoqNames coq_names(const FormalParameters& parameters);

/// The hypotheses on the parameters as premises of the lemma, one a line: "0 < xi -> xi <= (1 / 4) ->".
[[nodiscard]] std::string range_premises(const FormalParameters& parameters);

/// The tactics that begin the proof: the names of parameters and hypotheses, of which `further` more follow those on
/// the ranges, and the roots.
[[nodiscard]] std::string introduction(const FormalParameters& parameters, std::size_t further);

}  // namespace delcert
