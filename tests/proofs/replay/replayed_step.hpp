#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "proofs/prover/proof_log.hpp"
#include "proofs/replay/replay.hpp"
#include "tests/proofs/prover/prove_text.hpp"

namespace delcert::test {

/// What the prover writes about a step, which it has to prove.
inline nlohmann::ordered_json logged(const std::string& lines) {
  const Step of = step(lines);
  const StepOutcome outcome = prove(of);
  EXPECT_EQ(outcome.verdict, Verdict::proved);
  return nlohmann::ordered_json::parse(proof_log_line("c", of, of.constants, outcome));
}

/// "accepted", or why a log of this step alone is not.
inline std::string replayed(const nlohmann::ordered_json& step) {
  std::istringstream log(proof_log_head("c", "c.toml", "name = 'c'") + step.dump() + "\n");
  try {
    const replay::Totals totals = replay::replay_as_logged(log);
    EXPECT_EQ(totals.steps, 1U);
    return "accepted";
  } catch (const replay::Rejected& rejected) {
    return rejected.what();
  } catch (const replay::Malformed& malformed) {
    return std::string("malformed: ") + malformed.what();
  }
}

}  // namespace delcert::test
