#include "kernel/manifold/quotient/finite_group.hpp"

#include <cstdint>
#include <map>
#include <string>

#include "support/error.hpp"

namespace delcert {

namespace {

/// The exponents of the generators in a word.
using Exponents = std::vector<std::int64_t>;

}  // namespace

FiniteGroup closure(const InvariantForm& form, const std::vector<FieldMatrix>& generators, std::size_t greatest_order) {
  const std::size_t letters = generators.size();
  FiniteGroup group;
  group.elements.push_back(FieldMatrix::identity(form.matrix().order()));
  std::map<FieldMatrix, std::size_t, Precedes> found{{group.elements.front(), 0}};
  std::vector<Exponents> exponents{Exponents(letters)};
  std::vector<Exponents> relations;
  for (std::size_t at = 0; at < group.elements.size(); ++at) {
    for (std::size_t letter = 0; letter < letters; ++letter) {
      const FieldMatrix next = group.elements[at] * generators[letter];
      Exponents word = exponents[at];
      ++word[letter];
      const auto [position, is_new] = found.try_emplace(next, group.elements.size());
      if (is_new) {
        if (group.elements.size() == greatest_order)
          throw Rejection("the generators give more than " + std::to_string(greatest_order) +
                          " elements: the group is not finite, or too large");
        group.elements.push_back(next);
        exponents.push_back(std::move(word));
      } else {
        const Exponents& known = exponents[position->second];
        for (std::size_t k = 0; k < letters; ++k) word[k] -= known[k];
        relations.push_back(std::move(word));
      }
    }
  }
  group.abelianisation = abelian_group(letters, relations);
  return group;
}

void require_free(const FiniteGroup& group) {
  for (std::size_t at = 1; at < group.elements.size(); ++at) {
    const FieldMatrix& element = group.elements[at];
    if (!determinant(element - FieldMatrix::identity(element.order())).is_zero()) continue;
    std::string rows;
    for (std::size_t row = 0; row < element.order(); ++row) {
      std::string entries;
      for (std::size_t column = 0; column < element.order(); ++column)
        entries += (column == 0 ? "" : ", ") + element(row, column).text();
      rows += (row == 0 ? "[" : ", [") + entries + "]";
    }
    throw Rejection("the group does not act freely: the element [" + rows +
                    "] has the eigenvalue 1, so it fixes points");
  }
}

}  // namespace delcert
