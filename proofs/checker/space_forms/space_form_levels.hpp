#pragma once

#include <string>

#include "proofs/checker/report/report.hpp"
#include "proofs/checker/space_forms/lifts.hpp"

namespace delcert::checker {

/// Level 0 of space forms, as those of run.hpp; the group has been verified.
std::string check_input_on_space_form(const Certificate& c, Lifts& lifts, Report& report);

/// The rules 0.distortion and 0.metric-distortion.
void check_distortion(const Certificate& c, Report& report);

}  // namespace delcert::checker
