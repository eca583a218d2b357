#pragma once

#include <string>
#include <vector>

#include "kernel/run/run.hpp"
#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/run_parameters.hpp"

namespace delcert {

/// Derives the levels from a certified run on a flat torus or a ball, checking the inequalities of the format on the
/// way; reasons for levels that are not reached are appended to `reasons`. Level 3 is searched only if selected.
/// Precondition: the input items of `atlas` hold, and the run is certified.
template <int m>
[[nodiscard]] Claims derive_claims(const FlatAtlas<m>& atlas, const RunParameters& parameters, const RunResult<m>& run,
                                   const LevelSelection& selection, const Progress& progress,
                                   std::vector<std::string>& reasons);

}  // namespace delcert
