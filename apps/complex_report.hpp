#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/manifold/complex_file.hpp"
#include "proofs/certificate/given_complex_claims.hpp"
#include "proofs/certification/stage_clock.hpp"

namespace delcert {

/// What `delcert certify --complex` says, for people and for programs.
struct ComplexReport {
  std::string manifold;
  int dimension = 0;
  Curvature curvature = Curvature::zero;
  std::size_t points = 0;
  std::size_t generators = 0;
  std::size_t elements = 0;  ///< different ones, without the identity
  GivenComplexClaims claims;
  std::string checker;  ///< what delcert-check said, as JSON
  std::vector<StageClock::Stage> stages;
  std::string certificate;  ///< the file
};

/// A page of text. Decimal figures in it are rounded in the safe direction and marked by ≥ or ≤.
[[nodiscard]] std::string report_text(const ComplexReport& report);
/// The same as JSON; exact numbers are strings.
[[nodiscard]] std::string report_json(const ComplexReport& report);

/// A message of delcert-check in the names of the file: "simplex {0, 1, 5}" is "simplex {a, b, c}", "label 5" is "point
/// c", "generator 2" is "generator b". Numbers that name nothing stay.
[[nodiscard]] std::string in_names_of(const ComplexDescription& complex, std::string_view message);

/// The findings in what delcert-check printed as JSON, a line each, in the names of the file; empty if it verified.
/// Throws std::runtime_error if this is no such output.
[[nodiscard]] std::string findings_text(const ComplexDescription& complex, const std::string& output);

}  // namespace delcert
