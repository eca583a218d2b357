#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "proofs/formula/claim.hpp"
#include "proofs/prover/slack.hpp"
#include "proofs/prover/vacuity.hpp"

namespace delcert {

/// The heads of the tables that `delcert prove` prints, in Markdown.
[[nodiscard]] std::string step_table_head();
[[nodiscard]] std::string slack_table_head();

/// What is said of a step that has been decided: "proved", "refuted", "undecided", or "vacuous" for what is proved and
/// about nothing. The vacuity is asked for of what is proved only.
[[nodiscard]] std::string_view verdict_text(const StepOutcome& outcome, const Vacuity& vacuity);

/// A row for a step: where it stands, how it was decided, a counterexample or what is left.
[[nodiscard]] std::string step_row(const Claim& claim, const Step& step, const StepOutcome& outcome,
                                   const Vacuity& vacuity, double seconds);

/// A row for a constant: as stated, as proved, as refuted.
[[nodiscard]] std::string slack_row(const Claim& claim, const Step& step, const Slack& slack);

/// The same as JSON; no times, so that it is the same everywhere.
[[nodiscard]] nlohmann::ordered_json step_json(const Claim& claim, const Step& step, const StepOutcome& outcome,
                                               const Vacuity& vacuity);
[[nodiscard]] nlohmann::ordered_json slack_json(const Slack& slack);

}  // namespace delcert
