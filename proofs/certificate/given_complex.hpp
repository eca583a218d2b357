#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kernel/manifold/complex_file.hpp"
#include "kernel/simplex/vector.hpp"
#include "proofs/certificate/placed_complex.hpp"

namespace delcert {

/// A complex that a file gives, as a certificate states it.
template <int m>
struct GivenComplex {
  std::vector<Vector<Rational, m>> points;  ///< conformal coordinates
  PlacedComplex<m> complex;                 ///< `loops` has an empty one for each letter in `without_loop`
  std::vector<FieldMatrix> elements;        ///< by number, the identity first
  /// Names of generators and translations along which no closed path from label 0 was found among the first 50 000
  /// places: then the group of the complex is, as far as was looked, a smaller one.
  std::vector<std::string> without_loop;
};

/// Every simplex is moved so that its first vertex is at the identity; equal elements, compared exactly, become one.
/// Whether this is a triangulation of anything is not asked here. Throws Rejection, naming the generator, if one is no
/// isometry or the identity. Precondition: m is the dimension of the description.
template <int m>
[[nodiscard]] GivenComplex<m> place_complex(const ComplexDescription& description);

}  // namespace delcert
