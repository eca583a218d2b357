#pragma once

#include <algorithm>

#include "proofs/checker/core/complex.hpp"
#include "proofs/checker/parts/chunk_items.hpp"

namespace delcert::checker::core {

/// The neighbours of the vertices of a simplex that are not vertices of it: the nearest other points to its
/// circumcentre are among them (docs/levels/core.md, Margins).
class AroundSimplex {
 public:
  /// Keeps a reference. Precondition: core.edges holds.
  explicit AroundSimplex(Complex& complex) : complex_(complex), seen_(complex.size()) {}

  /// Calls f(label, element) for each of them, at the element where it is beside the simplex.
  template <class F>
  void visit(std::uint32_t s, const F& f) {
    const Label* labels = &complex_.data.labels[s * complex_.vertices()];
    const Label* end = labels + complex_.vertices();
    for (std::size_t k = 0; k < complex_.vertices(); ++k) {
      const Elements::Id g = complex_.element(s, k);
      require_star(labels[k]);
      for (std::size_t at = 0; at < complex_.neighbours.size(labels[k]); ++at) {
        const Neighbour& neighbour = complex_.neighbours.of(labels[k])[at];
        const Seen now{s, complex_.elements.product(g, neighbour.phi)};
        if (seen_[neighbour.label] == now) continue;
        seen_[neighbour.label] = now;
        // By core.edges a label of the simplex is one of its vertices here.
        if (std::find(labels, end, neighbour.label) == end) f(neighbour.label, now.element);
      }
    }
  }

 private:
  struct Seen {
    std::uint32_t simplex = UINT32_MAX;
    Elements::Id element = 0;
    bool operator==(const Seen&) const = default;
  };
  Complex& complex_;
  std::vector<Seen> seen_;  // of each label, beside which simplex it was seen last
};

}  // namespace delcert::checker::core
