#include "kernel/topology/abelian_group.hpp"

#include <algorithm>
#include <regex>
#include <string_view>

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

bool is_group_text(const std::string& text) {
  static const std::regex summand(R"(Z|Z\^(\d{1,9})|Z/(\d{1,99})|\(Z/(\d{1,99})\)\^(\d{1,5}))");
  constexpr std::string_view separator = " + ";
  constexpr std::size_t most_bytes = 1000;
  if (text == "0") return true;
  AbelianGroup group;
  for (std::size_t begin = 0; text.size() <= most_bytes; begin += separator.size()) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    std::smatch match;
    const std::string part = text.substr(begin, end - begin);
    if (!std::regex_match(part, match, summand)) return false;
    if (match[2].matched || match[3].matched) {
      const std::size_t copies = match[4].matched ? std::stoul(match[4]) : 1;
      group.torsion.insert(group.torsion.end(), copies, Integer(match[2].matched ? match[2].str() : match[3].str()));
    } else {
      group.free_rank += match[1].matched ? std::stoul(match[1]) : 1;
    }
    begin = end;
    if (end == text.size()) break;
  }
  for (std::size_t at = 0; at < group.torsion.size(); ++at) {
    if (group.torsion[at] < 2 || (at > 0 && group.torsion[at] % group.torsion[at - 1] != 0)) return false;
  }
  return group_text(group) == text;
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
