#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "proofs/checker/certificate/space_form.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

/// What was verified of a group.
struct Group {
  std::string summary;
  std::string size;  // "order 120", "14 sides", "6 cosets of its lattice"
  /// Of a presentation: how many generators, and the exponents of each in the relations.
  std::size_t letters = 0;
  std::vector<std::vector<std::int64_t>> relations{};
};

/// Whether all generators keep the orientation. Precondition: they are isometries.
bool keeps_orientation(const SpaceForm& form);

/// The presented group made commutative, H_1 of the quotient.
std::string first_homology(const Group& group);

/// Checks the rules group.*. Throws Undecided.
Group check_group(const SpaceForm& form, Report& report);

// The same for each curvature, after every generator was found to be an isometry.
Group spherical_group(const SpaceForm& form, Report& report);
Group flat_group(const SpaceForm& form, Report& report);
Group hyperbolic_group(const SpaceForm& form, Report& report);

}  // namespace delcert::checker
