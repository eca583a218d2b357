#pragma once

#include <string>

#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

namespace core {
class Core;
}

// Each function checks the rules of its level, records the broken ones in the report and returns in words what it
// looked at. Throws Undecided. Levels 4, 5 and 6 are the core's (core/core.hpp).
std::string check_level_0(const Certificate& c, Report& report);
/// `core`: of a torus, else none.
std::string check_level_1(const Certificate& c, core::Core* core, Report& report);
/// The rules of level 2 but those that make the complex a manifold: 2.count, and 2.homology, which presumes them.
/// `core`: where it has looked at the rules of level 2, else none.
std::string check_count(const Certificate& c, core::Core* core, Report& report);
std::string check_homology(const Certificate& c, Report& report);
std::string check_level_2s(const Certificate& c, Report& report);
std::string check_level_3(const Certificate& c, Report& report);
/// The parts of level 0 that show that the net is dense: the rules 0.cycle, 0.ball and 0.degree.
void check_cycle(const Certificate& c, Report& report);
void check_balls(const Certificate& c, Report& report);
void check_degree(const Certificate& c, Report& report);

/// The rule 1.facets, or that of another level, for the star of i, where there is no core.
void check_facets(const Certificate& c, Label i, Report& report, const char* rule = "1.facets");

}  // namespace delcert::checker
