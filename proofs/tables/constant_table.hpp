#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proofs/formula/claim.hpp"
#include "proofs/tables/constant_rows.hpp"
#include "proofs/tables/powers.hpp"
#include "proofs/tables/worst_ratios.hpp"

namespace delcert {

/// How far a constant of a step can be moved (`delcert prove --slack`).
struct StepSlack {
  Rational stated;
  std::optional<Rational> proved;  ///< the best value with which the step was proved
};
/// By "claim/step/constant".
using StepSlacks = std::map<std::string, StepSlack>;

/// Reads what `delcert prove --all --slack --json` prints. Throws InputError if it is something else.
[[nodiscard]] StepSlacks parse_step_slacks(const std::string& json, const std::string& file);

/// One line of the table of constants.
struct ConstantEntry {
  ConstantRow row;
  Rational paper;
  /// The best constant for which the same proof goes through; empty if the steps do not say.
  std::optional<Rational> provable;
  /// A constant with which the statement is refuted by the witness; empty if there is none.
  std::optional<Rational> refuted;
  std::string witness;  ///< a file of proofs/claims/witnesses, empty unless `refuted`
  /// What a search found for the statement as its claim has it; empty if it says nothing of it.
  WorstByDimension worst;
  /// By how much the term with the constant can be scaled before a search refutes the claim; empty if nothing is known.
  std::string power;
};

/// The lines, from the claims, their twins, the slack of their steps and what searches found. Throws InputError, naming
/// the row, for a claim, conclusion or step that there is not, a pattern that does not fit, and, unless the row says
/// what the paper has, a step that states another constant.
[[nodiscard]] std::vector<ConstantEntry> constant_entries(const ConstantRows& rows, const std::vector<Claim>& claims,
                                                          const StepSlacks& slacks, const WorstRatios& ratios = {},
                                                          const std::vector<PowerOfPlace>& powers = {});

/// The page docs/tables/constants.md.
[[nodiscard]] std::string constant_table_markdown(const std::vector<ConstantEntry>& entries,
                                                  const std::vector<LemmaWithoutConstant>& without);
/// The same columns as a longtable of LaTeX with the rules of booktabs, at most 345 pt wide.
[[nodiscard]] std::string constant_table_latex(const std::vector<ConstantEntry>& entries);

}  // namespace delcert
