#include "proofs/drawing/manifold/torus_manifold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "proofs/drawing/manifold/manifold_json.hpp"

namespace delcert {

TorusManifold::TorusManifold(const CertificateSummary& certificate, OnlyElements) : LinearManifold(certificate) {
  for (const auto& shift : certificate.elements) elements_.push_back(motions_.translation(shift));
}

TorusManifold::TorusManifold(const CertificateSummary& certificate) : TorusManifold(certificate, OnlyElements()) {
  const nlohmann::ordered_json json = manifold_json(certificate);
  std::vector<double> gram;
  for (const auto& row : json.at("gram")) {
    for (const auto& entry : row) gram.push_back(number_of(entry));
  }
  set_gram(gram);
  place_in_frame(certificate);
}

std::uint32_t TorusManifold::cell_sheet(const DrawnSimplex& simplex) {
  const Vector sum = sum_of_vertices(simplex);
  std::vector<std::int32_t> shift;
  for (std::size_t axis = 1; axis <= m_; ++axis)
    shift.push_back(-static_cast<std::int32_t>(std::floor(sum[axis] / static_cast<double>(simplex.labels.size()))));
  return motions_.translation(shift);
}

std::string TorusManifold::sheet_text(std::uint32_t sheet) const {
  std::string result;
  for (std::size_t axis = 1; axis <= m_; ++axis)
    result += fmt::format("{}{:.0f}", axis == 1 ? "" : " ", motions_.matrix(sheet)[axis * (m_ + 1)] + 0.0);
  return result;
}

std::vector<std::pair<ApproximateManifold::Place, ApproximateManifold::Place>> TorusManifold::domain() {
  std::vector<std::pair<Place, Place>> result;
  for (std::size_t corner = 0; corner < (std::size_t{1} << m_); ++corner) {
    for (std::size_t axis = 0; axis < m_; ++axis) {
      if ((corner >> axis & 1U) != 0) continue;
      Place from{1};
      for (std::size_t k = 0; k < m_; ++k) from[k + 1] = static_cast<double>(corner >> k & 1U);
      Place to = from;
      to[axis + 1] = 1;
      result.emplace_back(from, to);
    }
  }
  return result;
}

}  // namespace delcert
