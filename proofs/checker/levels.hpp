#pragma once

#include <string>

#include "proofs/checker/certificate.hpp"

namespace delcert::checker {

// Each function checks the rules of its level, records the broken ones in the report and returns what it looked at, in
// words. Throws Undecided. Levels 4, 5 and 6 have no rules: they follow from levels 1 and 2.

std::string check_level_0(const Certificate& certificate, Report& report);
std::string check_level_1(const Certificate& certificate, Report& report);
std::string check_level_2(const Certificate& certificate, Report& report);
std::string check_level_2s(const Certificate& certificate, Report& report);
std::string check_level_3(const Certificate& certificate, Report& report);

// Parts of level 0: the rule 0.cycle, and the rules 0.ball and 0.degree; together they show that the net is dense.
void check_cycle(const Certificate& certificate, Report& report);
void check_density(const Certificate& certificate, Report& report);

}  // namespace delcert::checker
