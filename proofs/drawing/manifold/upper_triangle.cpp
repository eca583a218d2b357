#include "proofs/drawing/manifold/upper_triangle.hpp"

#include <cstddef>

namespace delcert {

std::vector<double> triangle_times(const std::vector<double>& entries, const std::vector<double>& x) {
  std::vector<double> result(x.size());
  std::size_t at = 0;
  for (std::size_t row = 0; row < x.size(); ++row) {
    for (std::size_t column = row; column < x.size(); ++column) result[row] += entries[at++] * x[column];
  }
  return result;
}

std::vector<double> triangle_solution(const std::vector<double>& entries, const std::vector<double>& y) {
  std::vector<double> result(y.size());
  std::size_t at = entries.size();
  for (std::size_t row = y.size(); row-- > 0;) {
    double rest = y[row];
    for (std::size_t column = y.size(); column-- > row + 1;) rest -= entries[--at] * result[column];
    result[row] = rest / entries[--at];
  }
  return result;
}

}  // namespace delcert
