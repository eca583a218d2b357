#pragma once

#include <string>

namespace delcert::checker_tests {

/// What a certificate of a submanifold with points on it claims that is false by more than a relative 10⁻⁹, for M the
/// circle x² + y² = 1, the sphere x² + y² + z² = 1, or a polyhedron about the origin: by formulas and by samples, in
/// doubles, with a reader of its own. What is said may be false without being found so. Returns the first falsehood, or
/// nothing; of another zero set that it is another. Throws what its reader throws of a document that it cannot read.
std::string fault_of_hypersurface(const std::string& text);

}  // namespace delcert::checker_tests
