#include <algorithm>
#include <tuple>

#include "proofs/checker/core/rules.hpp"
#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker::core {
namespace {

void check_signs(Complex& complex, Report& report) {
  const Data& data = complex.data;
  complex.sign.assign(data.simplices(), 0);
  for (std::size_t s = 0; s < data.simplices(); ++s) {
    const auto has_sign = [&](int sign) {
      return complex.decide(
          [&]<class N>(In<N>) { return less(N(0), N(sign) * determinant(data.K, data.m, complex.lifts<N>(s))); });
    };
    complex.sign[s] = static_cast<std::int8_t>(has_sign(1) ? 1 : has_sign(-1) ? -1 : 0);
    if (complex.sign[s] == 0) report.reject("core.sign", [&] { return complex.name(s) + " is flat"; });
  }
}

/// Finds the edges, and with them the neighbours.
void check_edges(Complex& complex, Report& report) {
  struct Edge {
    Label i, j;
    Elements::Id phi;
    auto tied() const { return std::tie(i, j, phi); }
  };
  std::vector<Edge> edges, of_label;  // sorted: those from each label to greater ones, label after label
  for (Label i = 0; i < complex.size(); ++i) {
    of_label.clear();
    for (std::size_t at = 0; at < complex.star.size(i); ++at) {
      const auto [s, a] = complex.star.of(i)[at];
      for (std::size_t b = a + 1; b < complex.vertices(); ++b) {
        const Elements::Id phi = complex.elements.relative(complex.element(s, a), complex.element(s, b));
        of_label.push_back({i, complex.label(s, b), phi});
      }
    }
    std::sort(of_label.begin(), of_label.end(), [](const Edge& x, const Edge& y) { return x.tied() < y.tied(); });
    const auto same = [](const Edge& x, const Edge& y) { return x.tied() == y.tied(); };
    edges.insert(edges.end(), of_label.begin(), std::unique(of_label.begin(), of_label.end(), same));
  }
  for (std::size_t at = 1; at < edges.size(); ++at) {
    const Edge& edge = edges[at];
    if (edge.i != edges[at - 1].i || edge.j != edges[at - 1].j) continue;
    report.reject("core.edges", [&] {
      return "the edge {" + name_of(edge.i) + ", " + name_of(edge.j) +
             "} has different relative elements in two simplices";
    });
  }

  Lists<Neighbour>& neighbours = complex.neighbours;
  neighbours.begin.assign(complex.size() + std::size_t{1}, 0);
  for (const Edge& edge : edges) {
    ++neighbours.begin[edge.i + 1];
    ++neighbours.begin[edge.j + 1];
  }
  for (std::size_t j = 0; j < complex.size(); ++j) neighbours.begin[j + 1] += neighbours.begin[j];
  neighbours.items.resize(2 * edges.size());
  std::vector<std::uint64_t> next(neighbours.begin.begin(), neighbours.begin.end() - 1);
  for (const Edge& edge : edges) {
    neighbours.items[next[edge.i]++] = {edge.j, edge.phi};
    neighbours.items[next[edge.j]++] = {edge.i, complex.elements.inverse(edge.phi)};
  }
}

/// Whether the two simplices are not on the same side of their facet.
bool are_opposite(Complex& complex, const Hinge& hinge) {
  int product = (hinge.apex[0] + hinge.apex[1]) % 2 == 0 ? 1 : -1;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::uint32_t s = hinge.simplex[side];
    product *= complex.sign[s] * complex.elements.orientation(complex.element(s, hinge.apex[side] == 0 ? 1 : 0));
  }
  return product <= 0;  // 0: core.sign
}

struct Facet {
  std::array<Label, 4> labels{};
  std::uint32_t simplex = 0, apex = 0;
};

/// Of the simplices that have the same facet. Adds a hinge.
void check_facet(Complex& complex, std::vector<Facet>::const_iterator begin, std::vector<Facet>::const_iterator end,
                 Report& report) {
  const auto facet_of = [&] {
    return complex.name(begin->simplex) + " without its label " + name_of(complex.label(begin->simplex, begin->apex));
  };
  if (end - begin != 2) {
    report.reject("core.facets", [&] { return facet_of() + " is in " + std::to_string(end - begin) + " simplices"; });
    return;
  }
  const Facet &first = *begin, &second = begin[1];
  const Hinge hinge{{first.simplex, second.simplex},
                    {static_cast<std::uint8_t>(first.apex), static_cast<std::uint8_t>(second.apex)}};
  if (!are_opposite(complex, hinge)) {
    report.reject("core.facets", [&] {
      return complex.name(first.simplex) + " and " + complex.name(second.simplex) + " are on the same side of a facet";
    });
  }
  complex.hinges.push_back(hinge);
}

/// Finds the hinges.
void check_facets(Complex& complex, Report& report) {
  std::vector<Facet> facets;
  complex.hinges.reserve(complex.data.labels.size() / 2);
  complex.facets.assign(complex.size(), 0);
  for (Label i = 0; i < complex.size(); ++i) {
    if (!is_own(i)) continue;
    facets.clear();
    for (std::size_t at = 0; at < complex.star.size(i); ++at) {
      const auto [s, place] = complex.star.of(i)[at];
      // Those of which this is the least label.
      if (place > 1) continue;
      for (std::uint32_t apex = place == 0 ? 1 : 0; apex < (place == 0 ? complex.vertices() : 1); ++apex) {
        Facet& facet = facets.emplace_back(Facet{{}, s, apex});
        for (std::size_t k = 0; k + 1 < complex.vertices(); ++k)
          facet.labels[k] = complex.label(s, k + (k >= apex ? 1 : 0));
      }
    }
    std::sort(facets.begin(), facets.end(), [](const Facet& x, const Facet& y) {
      return std::tie(x.labels, x.simplex) < std::tie(y.labels, y.simplex);
    });
    for (auto begin = facets.begin(), end = begin; begin != facets.end(); begin = end, ++complex.facets[i]) {
      while (end != facets.end() && end->labels == begin->labels) ++end;
      check_facet(complex, begin, end, report);
    }
  }
}

/// Whether the simplex, at its vertex k, does not contain the direction: some other vertex has a negative coefficient.
template <class N>
Verdict is_outside(Complex& complex, std::size_t s, std::size_t k, const Vector<N>& direction) {
  const Data& data = complex.data;
  const Frame<N> frame(data.K, data.m, complex.lifts<N>(s), k);
  const N sign(complex.sign[s] * frame.sign());
  Verdict result = Verdict::refuted;
  for (std::size_t other = 0; other <= data.m && result != Verdict::proved; ++other) {
    if (other == k) continue;
    result = disjunction(result, less(sign * dot(frame.cofactors_of(other), direction, frame.d), N(0)));
  }
  return result;
}

void check_star(Complex& complex, Label i, Report& report) {
  const auto *begin = complex.star.of(i), *end = begin + complex.star.size(i);
  // A flat simplex is no witness: core.sign.
  const auto* witness = std::find_if(begin, end, [&](const auto& place) { return complex.sign[place.simplex] != 0; });
  if (witness == end) {
    if (begin == end) report.reject("core.stars", [&] { return "label " + name_of(i) + " is in no simplex"; });
    return;
  }
  const auto in_witness = [&]<class N>(In<N>) {
    const Lifts<N> lifts = complex.lifts<N>(witness->simplex);
    Vector<N> sum{};
    for (std::size_t other = 0; other < complex.vertices(); ++other)
      sum = add(sum, N(1), lifts[other] - lifts[witness->vertex]);
    return sum;
  };
  const Vector<Interval> filter = in_witness(In<Interval>{});
  for (const auto* place = begin; place != end; ++place) {
    const std::size_t s = place->simplex, k = place->vertex;
    if (place == witness || complex.sign[s] == 0) continue;
    const Elements::Id back = complex.elements.inverse(complex.element(witness->simplex, witness->vertex));
    const Elements::Id g = complex.elements.product(complex.element(s, k), back);
    const bool outside = complex.decide([&]<class N>(In<N> in) {
      if constexpr (std::is_same_v<N, Interval>) {
        return is_outside(complex, s, k, complex.elements.turned(g, filter));
      } else {
        return is_outside(complex, s, k, complex.elements.turned(g, in_witness(in)));
      }
    });
    if (outside) continue;
    report.reject("core.stars", [&] {
      return "at label " + name_of(i) + ", " + complex.name(s) + " and " + complex.name(witness->simplex) +
             " cover a direction twice";
    });
  }
}

}  // namespace

FaceCount count_faces(const Complex& complex, Label begin, Label end) {
  FaceCount count;
  for (Label i = begin; i < end; ++i) {
    const auto* const star = complex.star.of(i);
    const auto simplices = std::count_if(star, star + complex.star.size(i), [](auto at) { return at.vertex == 0; });
    std::int64_t edges = 0;
    Label before = i;
    for (std::size_t at = 0; at < complex.neighbours.size(i); ++at) {
      const Label j = complex.neighbours.of(i)[at].label;
      if (j > before) ++edges;
      before = std::max(before, j);
    }
    const std::int64_t vertices = complex.star.size(i) > 0 ? 1 : 0;
    count.simplices += simplices;
    count.euler_characteristic += vertices - edges + (complex.data.m == 2 ? simplices : complex.facets[i] - simplices);
  }
  return count;
}

void check_manifold(Complex& complex, Report& report) {
  check_signs(complex, report);
  check_edges(complex, report);
  check_facets(complex, report);
  in_parts("core.stars", Items::labels, complex.size(), report, [&](std::size_t begin, std::size_t end, Report& found) {
    for (auto i = static_cast<Label>(begin); i < end; ++i) check_star(complex, i, found);
    return Counts{};
  });
}

}  // namespace delcert::checker::core
