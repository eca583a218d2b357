#include "kernel/topology/integer_matrix.hpp"

#include <algorithm>

namespace delcert {

IntegerMatrix::IntegerMatrix(std::size_t rows, std::size_t columns) {
  fmpz_mat_init(matrix_, static_cast<slong>(rows), static_cast<slong>(columns));
}

std::vector<Integer> IntegerMatrix::invariant_factors() const {
  IntegerMatrix form(rows(), columns());
  if (rows() > 0 && columns() > 0) fmpz_mat_snf(form.matrix_, matrix_);
  std::vector<Integer> result;
  for (std::size_t at = 0; at < std::min(rows(), columns()); ++at) {
    if (fmpz_is_zero(form.entry(at, at)) != 0) break;
    fmpz_get_mpz(result.emplace_back().backend().data(), form.entry(at, at));
  }
  return result;
}

}  // namespace delcert
