#pragma once

#include <vector>

namespace delcert {

/// Ax and A⁻¹y for an upper triangular matrix with these entries on and above its diagonal, row by row, in doubles.
/// Precondition: m(m+1)/2 entries, m numbers.
[[nodiscard]] std::vector<double> triangle_times(const std::vector<double>& entries, const std::vector<double>& x);
[[nodiscard]] std::vector<double> triangle_solution(const std::vector<double>& entries, const std::vector<double>& y);

}  // namespace delcert
