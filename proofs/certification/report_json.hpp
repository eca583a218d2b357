#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "proofs/certification/run_report.hpp"

namespace delcert {

/// All levels, by their names: the entries of the certificate, with every bound in full.
[[nodiscard]] nlohmann::ordered_json levels_json(const Claims& claims, const Rational& sampling_radius);
[[nodiscard]] nlohmann::ordered_json levels_json(const std::vector<ClaimedLevel>& levels,
                                                 const Rational& sampling_radius);

/// What `report_text` says of a run, as JSON: docs/report-format.md.
[[nodiscard]] std::string report_json(const RunReport& report);

}  // namespace delcert
