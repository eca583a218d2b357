#pragma once

#include <string>
#include <vector>

#include "kernel/manifold/quotient/space_form.hpp"

namespace delcert::test {

/// Elements closed under inverses, with names.
struct SidePairings {
  std::vector<FieldMatrix> elements;
  std::vector<std::string> names;
};

/// a, A, b, B, …: the generators and their inverses.
inline SidePairings with_inverses(const SpaceFormDescription& description) {
  SidePairings result;
  for (std::size_t at = 0; at < description.generators.size(); ++at) {
    result.elements.push_back(description.generators[at]);
    result.elements.push_back(description.form.inverse_of(description.generators[at]));
    result.names.emplace_back(1, static_cast<char>('a' + at));
    result.names.emplace_back(1, static_cast<char>('A' + at));
  }
  return result;
}

/// All of these but the identity, numbered.
inline SidePairings numbered(const std::vector<FieldMatrix>& elements) {
  SidePairings result;
  for (const FieldMatrix& element : elements) {
    if (is_identity(element)) continue;
    result.names.push_back(std::to_string(result.elements.size()));
    result.elements.push_back(element);
  }
  return result;
}

}  // namespace delcert::test
