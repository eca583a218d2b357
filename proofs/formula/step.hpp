#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/formula/expression.hpp"

namespace delcert {

/// A hypothesis or a conclusion of a claim, or what a step says.
struct Statement {
  std::string name;
  std::string text;
  ExpressionPointer formula;
};

enum class ClaimStatus : unsigned char {
  paper,    ///< as the paper states it
  mended,   ///< with what the paper's statement lacks
  sharper,  ///< what the paper could have claimed: a better constant or exponent, with a proof
  user      ///< not in the paper
};

/// All of them, in the order of the enumeration.
inline constexpr std::array claim_statuses = {ClaimStatus::paper, ClaimStatus::mended, ClaimStatus::sharper,
                                              ClaimStatus::user};

[[nodiscard]] std::string_view name_of(ClaimStatus status);

/// What a parameter of a step runs through: real numbers or integers between two ends, or without end.
struct StepRange {
  bool is_integer = false;
  std::optional<Rational> lower;  ///< nothing: −∞
  std::optional<Rational> upper;  ///< nothing: ∞
  bool has_lower = false;         ///< the lower end belongs to it
  bool has_upper = false;

  [[nodiscard]] bool contains(const Rational& x) const;
};

/// Reads "(0, 1/4]", "[1, infinity)", "integer [1, infinity)", "(-infinity, 0]". Throws FormulaError for anything else
/// and for a range without a number in it.
[[nodiscard]] StepRange parse_step_range(std::string_view text);

/// The text that reads as this range.
[[nodiscard]] std::string step_range_text(const StepRange& range);

/// A statement about numbers that a proof uses: true for all parameters that the hypotheses allow.
struct Step {
  std::string name;
  std::string lines;  ///< of the paper's LaTeX, such as "612-614, 640"; may be empty for a user's step
  ClaimStatus status = ClaimStatus::user;
  std::string note;
  std::map<std::string, StepRange> parameters;
  std::vector<Statement> abbreviations;  ///< `let`: terms, each of parameters, constants and abbreviations before it
  std::vector<Statement> hypotheses;     ///< constraints between parameters
  std::map<std::string, Rational> constants;
  Statement claim;
};

/// The abbreviations replaced by what they stand for, the constants by their values, and the definitions of the
/// vocabulary by their bodies: a formula about the parameters alone.
[[nodiscard]] ExpressionPointer expanded(const Step& step, const ExpressionPointer& formula);
/// The same with other values for the constants. Precondition: `constants` has all names of `step.constants`.
[[nodiscard]] ExpressionPointer expanded(const Step& step, const std::map<std::string, Rational>& constants,
                                         const ExpressionPointer& formula);

}  // namespace delcert
