#include "proofs/checker/core/complex.hpp"

#include "proofs/checker/parts/chunk_items.hpp"

namespace delcert::checker::core {

Complex::Complex(const Data& given) : data(given), elements(given) {
  std::vector<std::uint64_t>& begin = star.begin;
  begin.assign(size() + std::size_t{1}, 0);
  for (const Label j : data.labels) ++begin[j + 1];
  for (std::size_t j = 0; j < size(); ++j) begin[j + 1] += begin[j];
  star.items.resize(data.labels.size());
  std::vector<std::uint64_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t s = 0; s < data.simplices(); ++s) {
    for (std::uint32_t k = 0; k < vertices(); ++k) star.items[next[label(s, k)]++] = {s, k};
  }
}

std::string Complex::name(std::size_t s) const {
  std::string text = "simplex {";
  for (std::size_t k = 0; k < vertices(); ++k) text += (k == 0 ? "" : ", ") + name_of(label(s, k));
  return text + "}";
}

Elements::Id Complex::element_beyond(const Hinge& hinge) {
  const auto [s, t] = hinge.simplex;
  const std::size_t on_facet_s = hinge.apex[0] == 0 ? 1 : 0, on_facet_t = hinge.apex[1] == 0 ? 1 : 0;
  // Of the same label, the first of the facet.
  const Elements::Id to_s = element(s, on_facet_s),
                     phi = elements.relative(element(t, on_facet_t), element(t, hinge.apex[1]));
  return elements.product(to_s, phi);
}

}  // namespace delcert::checker::core
