#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kernel/perturb/space_form_run.hpp"
#include "proofs/certificate/space_form_writer.hpp"

namespace delcert {

/// Derives the levels of docs/certificate-format.md from a certified run on a space form: measures what levels 2s, 5
/// and 6 need, and checks the inequalities of the format on the way; reasons for levels that are not reached are
/// appended to `reasons`. Margins have 12 significant binary digits, rounded to the safe side. Level 0 is claimed if no
/// two lifts of net points are nearer than separation·ε. Throws std::invalid_argument if the run is not certified.
template <int m>
[[nodiscard]] SpaceFormClaims derive_space_form_claims(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters,
                                                       const SpaceFormRun<m>& run, const LevelSelection& selection,
                                                       const Progress& progress, std::vector<std::string>& reasons);

/// Writes the certificate of a run with these claims.
template <int m>
void write_space_form_run(const std::filesystem::path& path, const SpaceFormAtlas<m>& atlas,
                          const RunParameters& parameters, const SpaceFormRun<m>& run, const SpaceFormClaims& claims,
                          const Progress& progress = no_progress());

/// Whether no two lifts of net points are nearer than this, for certain. Precondition: not more than the radius of a
/// patch.
template <int m>
[[nodiscard]] bool is_separated(const SpaceFormAtlas<m>& atlas, const Rational& distance);

/// Parameters of a measured run on a space form: those of `measured_parameters`, as certificates have them.
[[nodiscard]] RunParameters space_form_parameters(Dimension dimension, std::uint64_t seed);

}  // namespace delcert
