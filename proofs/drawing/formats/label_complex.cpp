#include "proofs/drawing/formats/label_complex.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/topology/edge_contraction.hpp"
#include "kernel/topology/homology.hpp"
#include "kernel/topology/orientation.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// By labels, in the order of the rows.
LabelComplex numbered(std::size_t dimension, const std::vector<std::uint32_t>& rows) {
  LabelComplex result;
  result.dimension = dimension;
  result.labels = rows;
  std::sort(result.labels.begin(), result.labels.end());
  result.labels.erase(std::unique(result.labels.begin(), result.labels.end()), result.labels.end());
  for (const std::uint32_t label : rows) {
    const auto found = std::lower_bound(result.labels.begin(), result.labels.end(), label);
    result.simplices.push_back(static_cast<std::uint32_t>(found - result.labels.begin()));
  }
  const FacetDegrees degrees = facet_degrees(PureComplex(Dimension(static_cast<int>(dimension)), result.simplices));
  if (degrees.more != 0)
    throw InputError(
        fmt::format("the complex is no manifold: {} of its facets are in three simplices or more", degrees.more));
  result.is_closed = degrees.one == 0;
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
