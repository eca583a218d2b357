#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "proofs/checker/report.hpp"
#include "proofs/checker/space_form.hpp"

namespace delcert::checker {

/// What was verified of a group, and its elements that can take one point of the certificate near another.
struct Group {
  std::vector<FieldMatrix> elements;  // the identity first
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

/// Checks the rules group.* and finds all elements with d(x, gamma y) <= reach for some x, y at most `spread` from o,
/// and perhaps others. The elements are complete only if nothing is reported. Throws Undecided.
Group check_group(const SpaceForm& form, const Rational& reach, const Rational& spread, Report& report);

// The same for each curvature, after every generator was found to be an isometry.
Group spherical_group(const SpaceForm& form, Report& report);
Group flat_group(const SpaceForm& form, const Rational& reach, const Rational& spread, Report& report);
Group hyperbolic_group(const SpaceForm& form, const Rational& reach, const Rational& spread, Report& report);

}  // namespace delcert::checker
