#include "proofs/drawing/manifold/linear_manifold.hpp"

#include <algorithm>
#include <cmath>

#include "proofs/drawing/manifold/manifold_json.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

std::vector<double> cholesky_factor(const std::vector<double>& gram, std::size_t m) {
  std::vector<double> lower(m * m);
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      double rest = gram[row * m + column];
      for (std::size_t k = 0; k < column; ++k) rest -= lower[row * m + k] * lower[column * m + k];
      lower[row * m + column] = row == column ? std::sqrt(rest) : rest / lower[column * m + column];
    }
  }
  return lower;
}

}  // namespace

std::vector<double> unit_matrix(std::size_t m) {
  std::vector<double> result(m * m);
  for (std::size_t k = 0; k < m; ++k) result[k * m + k] = 1;
  return result;
}

std::vector<std::vector<double>> net_of(const CertificateSummary& certificate) {
  std::vector<std::vector<double>> result;
  for (const auto& point : certificate.net()) result.push_back(doubles_of(point));
  if (result.size() < certificate.points.size()) throw InputError("net: there is not a point for each label");
  return result;
}

LinearManifold::LinearManifold(const CertificateSummary& certificate)
    : m_(static_cast<std::size_t>(certificate.manifold.dimension.value)), motions_(m_ + 1) {
  if (m_ < 1 || m_ > 4) throw InputError("manifold: the dimension is not in 1 to 4");
  unit_ = approximate_double(certificate.parameter("sampling_radius"));
  cholesky_ = unit_matrix(m_);
}

void LinearManifold::set_gram(const std::vector<double>& gram) { cholesky_ = cholesky_factor(gram, m_); }

void LinearManifold::place_in_frame(const CertificateSummary& certificate) {
  for (const auto& exact : certificate.points) {
    std::vector<double> point = doubles_of(exact);
    point.resize(m_);
    Vector place{1};
    std::copy(point.begin(), point.end(), place.begin() + 1);
    points_.push_back(place);
  }
}

std::array<double, 4> LinearManifold::cartesian(const Vector& x) const {
  std::array<double, 4> result{};
  for (std::size_t column = 0; column < m_; ++column) {
    for (std::size_t row = column; row < m_; ++row) result[column] += cholesky_[row * m_ + column] * x[row + 1];
  }
  return result;
}

LinearManifold::Vector LinearManifold::vertex(std::uint32_t label, std::uint32_t element) const {
  return motions_.apply(elements_.at(element), points_.at(label));
}

LinearManifold::Vector LinearManifold::sum_of_vertices(const DrawnSimplex& simplex) const {
  Vector sum{};
  for (std::size_t k = 0; k < simplex.labels.size(); ++k) {
    const Vector x = vertex(simplex.labels[k], simplex.elements[k]);
    for (std::size_t axis = 0; axis <= m_; ++axis) sum[axis] += x[axis];
  }
  return sum;
}

std::uint32_t LinearManifold::vertex_sheet(std::uint32_t simplex_sheet, std::uint32_t element) {
  return motions_.product(simplex_sheet, elements_.at(element));
}

std::uint32_t LinearManifold::simplex_sheet(std::uint32_t vertex_sheet, std::uint32_t element) {
  return motions_.product(vertex_sheet, motions_.inverse(elements_.at(element)));
}

std::uint32_t LinearManifold::relative_element(std::uint32_t from, std::uint32_t to) {
  return motions_.product(motions_.inverse(elements_.at(from)), elements_.at(to));
}

std::optional<ApproximateManifold::Place> LinearManifold::place(std::uint32_t label, std::uint32_t sheet) const {
  Place result{};
  const Vector x = motions_.apply(sheet, points_.at(label));
  std::copy(x.begin(), x.end(), result.begin());
  return result;
}

std::string LinearManifold::step_text(std::uint32_t from, std::uint32_t to) {
  return sheet_text(motions_.product(to, motions_.inverse(from)));
}

std::optional<ApproximateManifold::ChartPlace> LinearManifold::in_chart(std::uint32_t, std::uint32_t j,
                                                                        std::uint32_t element) const {
  return cartesian(motions_.apply(element, points_.at(j)));
}

std::optional<SquaredEdges> LinearManifold::squared_edges(const DrawnSimplex& simplex) const {
  std::array<std::array<double, 4>, most_vertices_of_a_simplex> places{};
  for (std::size_t k = 0; k <= m_; ++k) places[k] = cartesian(vertex(simplex.labels[k], simplex.elements[k]));
  return squares_between(m_ + 1, [&](std::size_t j, std::size_t k) {
    double square = 0;
    for (std::size_t axis = 0; axis < m_; ++axis)
      square += (places[j][axis] - places[k][axis]) * (places[j][axis] - places[k][axis]);
    return square;
  });
}

std::optional<std::vector<double>> LinearManifold::drawn(DrawingModel, const Place& place) const {
  Vector x{};
  std::copy(place.begin(), place.begin() + static_cast<std::ptrdiff_t>(x.size()), x.begin());
  const std::array<double, 4> y = cartesian(x);
  return std::vector<double>(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(m_));
}

}  // namespace delcert
