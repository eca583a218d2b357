#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/given_complex.hpp"
#include "proofs/certificate/run_parameters.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What is claimed of a given complex, and with which margins.
struct GivenComplexClaims {
  Claims levels;                         ///< 2, 4, 5 and 6 at most
  Rational longest_edge;                 ///< an upper bound
  std::vector<std::string> not_reached;  ///< why levels 4 and 6 are not claimed, by labels
};

/// Proposes levels 2 and 5, and 4 and 6 where enclosures show them: circumballs exist, and no neighbour of a vertex is
/// in one that it is no vertex of. Nothing of this is proved here: levels 2 and 5 are proposed of whatever the
/// simplices are, for a checker to decide.
template <int m>
[[nodiscard]] GivenComplexClaims claims_of(const InvariantForm& form, const GivenComplex<m>& given,
                                           const LevelSelection& selection, const Progress& progress);

/// Writes the certificate: of the group the generators, of the injectivity radius nothing.
template <int m>
void write_given_complex(const std::filesystem::path& path, const ComplexDescription& description,
                         const GivenComplex<m>& given, const GivenComplexClaims& claims, const Origin& origin,
                         const Progress& progress);

}  // namespace delcert
