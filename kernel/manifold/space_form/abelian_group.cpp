#include "kernel/manifold/space_form/abelian_group.hpp"

#include <flint/fmpz_mat.h>

#include <algorithm>

namespace delcert {

namespace {

std::string power_text(const std::string& base, std::size_t exponent) {
  if (exponent == 1) return base;
  return (base.size() > 1 ? "(" + base + ")" : base) + "^" + std::to_string(exponent);
}

}  // namespace

std::string name_of(const AbelianGroup& group) {
  std::string result = group.rank == 0 ? "" : power_text("Z", group.rank);
  for (std::size_t first = 0; first < group.torsion.size();) {
    std::size_t next = first;
    while (next < group.torsion.size() && group.torsion[next] == group.torsion[first]) ++next;
    result += (result.empty() ? "" : " + ") + power_text("Z/" + group.torsion[first].str(), next - first);
    first = next;
  }
  return result.empty() ? "0" : result;
}

AbelianGroup abelian_group(std::size_t generators, const std::vector<std::vector<std::int64_t>>& relations) {
  AbelianGroup result;
  result.rank = generators;
  if (relations.empty() || generators == 0) return result;
  fmpz_mat_t matrix;
  fmpz_mat_init(matrix, static_cast<slong>(relations.size()), static_cast<slong>(generators));
  for (std::size_t row = 0; row < relations.size(); ++row) {
    for (std::size_t column = 0; column < generators; ++column)
      fmpz_set_si(fmpz_mat_entry(matrix, static_cast<slong>(row), static_cast<slong>(column)), relations[row][column]);
  }
  fmpz_mat_t normal;
  fmpz_mat_init(normal, static_cast<slong>(relations.size()), static_cast<slong>(generators));
  fmpz_mat_snf(normal, matrix);
  const auto diagonal = static_cast<slong>(std::min(relations.size(), generators));
  for (slong k = 0; k < diagonal; ++k) {
    Integer entry;
    fmpz_get_mpz(entry.backend().data(), fmpz_mat_entry(normal, k, k));
    if (entry == 0) continue;
    --result.rank;
    if (entry != 1) result.torsion.push_back(entry);
  }
  fmpz_mat_clear(matrix);
  fmpz_mat_clear(normal);
  return result;
}

}  // namespace delcert
