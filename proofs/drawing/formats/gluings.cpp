#include "proofs/drawing/formats/gluings.hpp"

#include <algorithm>

#include "proofs/drawing/facet_table.hpp"

namespace delcert {

Gluings::Gluings(const LabelComplex& complex) : size_(complex.dimension + 1), gluings_(complex.simplices.size()) {
  const FacetTable facets(complex.simplices, size_);
  // Vertices increase, so those of a facet correspond in their order.
  const auto glue = [this](const FacetTable::Side& from, const FacetTable::Side& to) {
    Gluing& gluing = gluings_[from.simplex * size_ + from.without];
    gluing.simplex = to.simplex;
    std::uint8_t next = 0;
    for (std::size_t k = 0; k < size_; ++k) {
      if (k == from.without) continue;
      if (next == to.without) ++next;
      gluing.vertices[k] = next++;
    }
    gluing.vertices[from.without] = static_cast<std::uint8_t>(to.without);
  };
  for (std::size_t at = 1; at < facets.sides().size(); ++at) {
    if (!facets.is_same_as_before(at)) continue;
    glue(facets.sides()[at - 1], facets.sides()[at]);
    glue(facets.sides()[at], facets.sides()[at - 1]);
  }
}

bool Gluings::orient() {
  enum class Turn : unsigned char { open, kept, turned };
  std::vector<Turn> turns(count(), Turn::open);
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < count(); ++start) {
    if (turns[start] != Turn::open) continue;
    turns[start] = Turn::kept;
    open.push_back(start);
    while (!open.empty()) {
      const std::size_t from = open.back();
      open.pop_back();
      for (std::size_t facet = 0; facet < size_; ++facet) {
        const Gluing& gluing = at(from, facet);
        if (gluing.simplex == boundary) continue;
        const bool is_other = is_even(gluing.vertices, size_);
        const Turn wanted = (turns[from] == Turn::turned) != is_other ? Turn::turned : Turn::kept;
        Turn& turn = turns[gluing.simplex];
        if (turn == Turn::open) {
          turn = wanted;
          open.push_back(gluing.simplex);
        } else if (turn != wanted) {
          return false;
        }
      }
    }
  }
  const auto exchanged = [this, &turns](std::size_t simplex, std::size_t vertex) {
    if (turns[simplex] != Turn::turned || vertex + 2 < size_) return vertex;
    return vertex + 1 == size_ ? vertex - 1 : vertex + 1;
  };
  std::vector<Gluing> result(gluings_.size());
  for (std::size_t simplex = 0; simplex < count(); ++simplex) {
    for (std::size_t facet = 0; facet < size_; ++facet) {
      const Gluing& before = at(simplex, facet);
      Gluing& after = result[simplex * size_ + exchanged(simplex, facet)];
      after.simplex = before.simplex;
      if (before.simplex == boundary) continue;
      for (std::size_t k = 0; k < size_; ++k)
        after.vertices[exchanged(simplex, k)] =
            static_cast<std::uint8_t>(exchanged(before.simplex, before.vertices[k]));
    }
  }
  gluings_ = std::move(result);
  return true;
}

bool is_even(const Gluings::Permutation& permutation, std::size_t size) {
  bool result = true;
  for (std::size_t j = 0; j < size; ++j) {
    for (std::size_t k = j + 1; k < size; ++k) {
      if (permutation[j] > permutation[k]) result = !result;
    }
  }
  return result;
}

std::uint32_t lexicographic_index(const Gluings::Permutation& permutation, std::size_t size) {
  std::uint32_t result = 0;
  for (std::size_t j = 0; j < size; ++j) {
    std::uint32_t less = 0;
    for (std::size_t k = j + 1; k < size; ++k) less += permutation[k] < permutation[j];
    result = result * static_cast<std::uint32_t>(size - j) + less;
  }
  return result;
}

std::uint32_t alternating_index(const Gluings::Permutation& permutation, std::size_t size) {
  // Of two that follow each other from an even place on one is even.
  const std::uint32_t index = lexicographic_index(permutation, size);
  return (index & ~1U) | (is_even(permutation, size) ? 0U : 1U);
}

}  // namespace delcert
