#pragma once

#include <string>

#include "proofs/prover/prover.hpp"

namespace delcert {

/// A term or a statement as an S-expression: (<= (* x (- 1 x)) (/ 1 4)). Precondition: no quantifiers and definitions.
[[nodiscard]] std::string s_expression(const Expression& expression);

/// What another program needs to check the proof of a step, as one line of JSON (docs/prover.md, "The log").
/// Precondition: the outcome is that of the step with these constants, and proved.
[[nodiscard]] std::string proof_log_line(const std::string& claim, const Step& step,
                                         const std::map<std::string, Rational>& constants, const StepOutcome& outcome);

/// The first line of a log: the name of the claim, that of its file, and the file's text with its SHA-256. Without line
/// breaks in it, whatever the text is.
[[nodiscard]] std::string proof_log_head(const std::string& claim, const std::string& file, const std::string& text);

}  // namespace delcert
