#include "kernel/topology/abelian_group.hpp"

#include <algorithm>

#include "kernel/topology/integer_matrix.hpp"

namespace delcert {

std::string group_text(const AbelianGroup& group) {
  std::string result;
  const auto add = [&result](const std::string& summand) { result += (result.empty() ? "" : " + ") + summand; };
  if (group.free_rank == 1) add("Z");
  if (group.free_rank > 1) add("Z^" + std::to_string(group.free_rank));
  for (auto first = group.torsion.begin(); first != group.torsion.end();) {
    const auto last = std::find_if(first, group.torsion.end(), [&](const Integer& order) { return order != *first; });
    const std::string cyclic = "Z/" + first->str();
    add(last - first == 1 ? cyclic : "(" + cyclic + ")^" + std::to_string(last - first));
    first = last;
  }
  return result.empty() ? "0" : result;
}

AbelianGroup abelian_group(std::size_t generators, const std::vector<std::vector<std::int64_t>>& relations) {
  IntegerMatrix matrix(relations.size(), generators);
  for (std::size_t row = 0; row < relations.size(); ++row) {
    for (std::size_t column = 0; column < generators; ++column)
      fmpz_set_si(matrix.entry(row, column), relations[row][column]);
  }
  AbelianGroup result;
  result.torsion = matrix.invariant_factors();
  result.free_rank = generators - result.torsion.size();
  std::erase(result.torsion, Integer(1));
  return result;
}

}  // namespace delcert
