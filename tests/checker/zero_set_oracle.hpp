#pragma once

#include <string>

namespace delcert::checker_tests {

/// What a certificate of the circle x² + y² = 1, as a zero set with points on it, claims that is false by more than a
/// relative 10⁻⁹: by formulas for the circle and by samples, in doubles, with a reader of its own. What is said may be
/// false without being found so. Returns the first falsehood, or nothing; of another zero set that it is another.
/// Throws what its reader throws of a document that it cannot read.
std::string fault_of_zero_set_circle(const std::string& text);

}  // namespace delcert::checker_tests
