#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "kernel/perturb/perturbation.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certification/stage_clock.hpp"

namespace delcert {

// What the reports of all runs have in common.

/// Four significant digits, rounded down or up, exactly: "-1.235e+00" is the greatest such number below −1.2341.
[[nodiscard]] std::string decimal_lower(const Rational& x);
[[nodiscard]] std::string decimal_upper(const Rational& x);

/// A bound in JSON (docs/report-format.md): the exact number, the nearest double that is not better, from which side it
/// bounds, its unit; of a length or its square also the double in units of ε or ε².
[[nodiscard]] nlohmann::ordered_json bound_json(const Margin& margin, const Rational& sampling_radius);
[[nodiscard]] nlohmann::ordered_json lower_json(const Rational& x, Margin::Unit unit = Margin::Unit::one,
                                                const Rational& sampling_radius = Rational(1));
[[nodiscard]] nlohmann::ordered_json upper_json(const Rational& x, Margin::Unit unit = Margin::Unit::one,
                                                const Rational& sampling_radius = Rational(1));

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
