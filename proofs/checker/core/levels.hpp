#pragma once

#include "proofs/checker/certificate.hpp"
#include "proofs/checker/report.hpp"

namespace delcert::checker::core {

/// The rules of docs/levels/core.md for levels 2, 4, 5 and 6 of a flat torus or a space form, those of the chosen
/// levels; returns in words what was looked at. Throws Undecided.
std::string check_levels(const Certificate& c, const std::array<bool, level_names.size()>& chosen, Report& report);

}  // namespace delcert::checker::core
