#include "kernel/topology/abelian_group.hpp"

#include <algorithm>

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

}  // namespace delcert
