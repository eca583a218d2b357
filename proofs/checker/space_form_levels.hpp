#pragma once

#include <string>

#include "proofs/checker/chart.hpp"
#include "proofs/checker/report.hpp"

namespace delcert::checker {

// The levels of space forms that look at charts. As those of run.hpp; the group has been verified.
std::string check_input_on_space_form(const Certificate& c, const Lifts& lifts, Report& report);     // 0
std::string check_stars_in_charts(const Certificate& c, const Lifts& lifts, Report& report);         // 1
std::string check_stable_stars_in_charts(const Certificate& c, const Lifts& lifts, Report& report);  // 2s

/// The rules 0.distortion and 0.metric-distortion.
void check_distortion(const Certificate& c, Report& report);

/// reach < 9 epsilon and reach < injectivity radius: a chart shows one lift of a label at most.
bool is_shown_by_charts(const Certificate& c, const Rational& reach);

/// "simplex {3, 17, 90} in the star of 5".
std::string simplex_of_star(const Certificate& c, Label i, const Label* others);

}  // namespace delcert::checker
