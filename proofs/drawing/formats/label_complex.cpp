#include "proofs/drawing/formats/label_complex.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "kernel/topology/edge_contraction.hpp"
#include "kernel/topology/homology.hpp"
#include "proofs/drawing/facet_table.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// In how many simplices facets are: the boundary, and what no manifold has.
struct OddFacets {
  std::size_t in_one = 0;
  std::size_t in_more_than_two = 0;
};

OddFacets odd_facets(const std::vector<std::uint32_t>& simplices, std::size_t size) {
  const FacetTable facets(simplices, size);
  const std::size_t sides = facets.sides().size();
  OddFacets result;
  for (std::size_t first = 0, next = 0; first < sides; first = next) {
    do {
      ++next;
    } while (next < sides && facets.is_same_as_before(next));
    if (next - first == 1) ++result.in_one;
    if (next - first > 2) ++result.in_more_than_two;
  }
  return result;
}

/// By labels, in the order of the rows.
LabelComplex numbered(std::size_t dimension, const std::vector<std::uint32_t>& rows) {
  LabelComplex result;
  result.dimension = dimension;
  constexpr std::uint32_t in_no_simplex = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place_of(std::size_t{*std::max_element(rows.begin(), rows.end())} + 1, in_no_simplex);
  for (const std::uint32_t label : rows) place_of[label] = 0;
  for (std::uint32_t label = 0; label < place_of.size(); ++label) {
    if (place_of[label] == in_no_simplex) continue;
    place_of[label] = static_cast<std::uint32_t>(result.labels.size());
    result.labels.push_back(label);
  }
  result.simplices.reserve(rows.size());
  for (const std::uint32_t label : rows) result.simplices.push_back(place_of[label]);
  const OddFacets odd = odd_facets(result.simplices, dimension + 1);
  if (odd.in_more_than_two != 0)
    throw InputError(fmt::format("the complex is no manifold: {} of its facets are in three simplices or more",
                                 odd.in_more_than_two));
  result.is_closed = odd.in_one == 0;
  return result;
}

std::vector<std::string> homology_texts(const LabelComplex& complex) {
  std::vector<std::string> result;
  for (const AbelianGroup& group :
       homology(PureComplex(Dimension(static_cast<int>(complex.dimension)), complex.simplices)))
    result.push_back(group_text(group));
  return result;
}

}  // namespace

LabelComplex label_complex(const CertificateSummary& certificate) {
  const auto m = static_cast<std::size_t>(certificate.manifold.dimension.value);
  if (certificate.simplices.empty()) throw InputError("there are no simplices");
  std::vector<std::uint32_t> rows;
  rows.reserve(certificate.simplices.size() * (m + 1));
  for (std::size_t at = 0; at < certificate.simplices.size(); ++at) {
    const std::vector<std::uint32_t>& row = certificate.simplices[at];
    if (row.size() != 2 * m + 1)
      throw InputError(fmt::format("simplices[{}] has {} numbers, not {}", at, row.size(), 2 * m + 1));
    const auto end = row.begin() + static_cast<std::ptrdiff_t>(m + 1);
    if (std::adjacent_find(row.begin(), end, std::greater_equal<>()) != end)
      throw InputError(fmt::format("simplices[{}]: labels do not increase", at));
    if (*(end - 1) >= certificate.points.size())
      throw InputError(fmt::format("simplices[{}]: there is no label {}", at, *(end - 1)));
    rows.insert(rows.end(), row.begin(), end);
  }
  return numbered(m, rows);
}

Simplification simplified(const CertificateSummary& certificate, const LabelComplex& complex) {
  const bool is_manifold = std::any_of(certificate.levels.begin(), certificate.levels.end(),
                                       [](const auto& level) { return level.first == "2"; });
  if (!complex.is_closed) throw InputError("--simplify is for closed complexes; this one has a boundary");
  if (!is_manifold) throw InputError("--simplify is for manifolds; the certificate does not claim level 2");
  const ContractedComplex less = contract_edges(Dimension(static_cast<int>(complex.dimension)), complex.simplices);
  std::vector<std::uint32_t> rows;
  for (const std::uint32_t vertex : less.simplices) rows.push_back(complex.labels[vertex]);
  Simplification result{numbered(complex.dimension, rows), less.contractions, homology_texts(complex)};
  if (homology_texts(result.complex) != result.homology)
    throw Rejection("--simplify has changed the homology: the complex is no manifold, whatever its certificate claims");
  return result;
}

}  // namespace delcert
