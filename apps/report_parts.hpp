#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/stage_clock.hpp"
#include "kernel/perturb/perturbation.hpp"
#include "proofs/certificate/claims.hpp"

namespace delcert {

// What the reports of all runs have in common.

/// Four significant digits, rounded down or up, exactly: "-1.235e+00" is the greatest such number below −1.2341.
[[nodiscard]] std::string decimal_lower(const Rational& x);
[[nodiscard]] std::string decimal_upper(const Rational& x);

/// "Z", "Z^2", "Z": H₀ … H_m.
[[nodiscard]] std::vector<std::string> homology_texts(const ManifoldClaim& manifold);

/// One line about candidates and tries.
[[nodiscard]] std::string tries_text(const PerturbationStatistics& statistics);

/// Seconds and decisions of each stage and of all, and which rungs settled these.
[[nodiscard]] std::string stages_text(const std::vector<StageClock::Stage>& stages);
[[nodiscard]] nlohmann::ordered_json stages_json(const std::vector<StageClock::Stage>& stages);

/// The highest memory use of this process so far.
[[nodiscard]] double peak_memory_in_mib();

}  // namespace delcert
