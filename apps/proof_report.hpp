#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "proofs/formula/claim.hpp"
#include "proofs/prover/slack.hpp"

namespace delcert {

/// The heads of the tables that `delcert prove` prints, in Markdown.
[[nodiscard]] std::string step_table_head();
[[nodiscard]] std::string slack_table_head();

/// A row for a step: where it stands, how it was decided, a counterexample or what is left.
[[nodiscard]] std::string step_row(const Claim& claim, const Step& step, const StepOutcome& outcome, double seconds);

/// A row for a constant: as stated, as proved, as refuted.
[[nodiscard]] std::string slack_row(const Claim& claim, const Step& step, const Slack& slack);

/// The same as JSON; no times, so that it is the same everywhere.
[[nodiscard]] nlohmann::ordered_json step_json(const Claim& claim, const Step& step, const StepOutcome& outcome);
[[nodiscard]] nlohmann::ordered_json slack_json(const Slack& slack);

}  // namespace delcert
