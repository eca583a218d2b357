#pragma once

#include <string>
#include <vector>

#include "proofs/checker/report.hpp"
#include "proofs/checker/space_form.hpp"

namespace delcert::checker {

/// What was verified of a group, and its elements that can take one point of the certificate near another.
struct Group {
  std::vector<FieldMatrix> elements;  // the identity first
  std::string summary;
};

/// Checks the rules group.* and finds all elements with d(x, gamma y) <= reach for some x, y at most `spread` from o,
/// and perhaps others. The elements are complete only if nothing is reported. Throws Undecided.
Group check_group(const SpaceForm& form, const Rational& reach, const Rational& spread, Report& report);

// The same for each curvature, after every generator was found to be an isometry.
Group spherical_group(const SpaceForm& form, Report& report);
Group flat_group(const SpaceForm& form, const Rational& reach, const Rational& spread, Report& report);
Group hyperbolic_group(const SpaceForm& form, const Rational& reach, const Rational& spread, Report& report);

}  // namespace delcert::checker
