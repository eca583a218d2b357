#include "proofs/drawing/manifold/space_form_manifold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kernel/manifold/submanifold/dense.hpp"
#include "proofs/drawing/manifold/dirichlet_wires.hpp"
#include "proofs/drawing/manifold/manifold_json.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using ManifoldJson = nlohmann::ordered_json;

/// How many of the copies of the origin are looked at for the walls between them.
constexpr std::size_t most_walls = 64;
constexpr std::size_t most_elements = 600;

/// tan⁻¹ √q / √q for q > 0, tanh⁻¹ √−q / √−q for q < 0.
double arc_factor(double q) {
  if (std::fabs(q) < 1e-8) return 1 - q / 3;
  const double root = std::sqrt(std::fabs(q));
  return q > 0 ? std::atan(root) / root : std::atanh(root) / root;
}

std::vector<double> product_of(const std::vector<double>& a, const std::vector<double>& b, std::size_t order) {
  std::vector<double> result(order * order);
  for (std::size_t row = 0; row < order; ++row) {
    for (std::size_t k = 0; k < order; ++k) {
      for (std::size_t column = 0; column < order; ++column)
        result[row * order + column] += a[row * order + k] * b[k * order + column];
    }
  }
  return result;
}

/// The number field of a certificate, in doubles.
class Field {
 public:
  explicit Field(const ManifoldJson& json) {
    const std::vector<double> interval = numbers_of(json.at("root"));
    root_ = root_of(numbers_of(json.at("field")), interval.at(0), interval.at(1));
  }
  [[nodiscard]] double element(const ManifoldJson& polynomial) const { return value_of(numbers_of(polynomial), root_); }
  [[nodiscard]] std::vector<double> matrix(const ManifoldJson& rows) const {
    std::vector<double> result;
    for (const auto& row : rows) {
      for (const auto& entry : row) result.push_back(element(entry));
    }
    return result;
  }

 private:
  double root_ = 0;
};

}  // namespace

SpaceFormManifold::SpaceFormManifold(const CertificateSummary& certificate)
    : LinearManifold(certificate),
      curvature_(certificate.family == "spherical"    ? 1
                 : certificate.family == "hyperbolic" ? -1
                                                      : 0) {
  read_letters(manifold_json(certificate));
  read_elements(certificate);
  std::vector<std::vector<double>> net = net_of(certificate);
  for (std::size_t label = 0; label < certificate.points.size(); ++label) {
    std::vector<double> point = doubles_of(certificate.points[label]);
    point.resize(m_);
    net[label].resize(m_);
    points_.push_back(point_near(net[label], point));
    for (double& entry : net[label]) entry = -entry;
    to_charts_.push_back(frame(net[label]));
  }
}

void SpaceFormManifold::add_letter(const std::vector<double>& letter) {
  const auto inverse = inverse_of(letter, m_ + 1);
  if (!inverse) throw InputError("manifold: a generator has no inverse");
  Motions::Matrix matrix{};
  Motions::Matrix back{};
  std::copy(letter.begin(), letter.end(), matrix.begin());
  std::copy(inverse->begin(), inverse->end(), back.begin());
  motions_.add_letter(matrix, back);
}

void SpaceFormManifold::read_letters(const ManifoldJson& json) {
  const Field field(json);
  set_gram(field.matrix(json.at("gram")));
  const std::size_t order = m_ + 1;
  // T, to the standard basis; of curvature 0 the frame's own is kept.
  std::vector<double> basis = unit_matrix(order);
  if (curvature_ != 0) {
    basis[0] = std::sqrt(std::fabs(field.element(json.at("time"))));
    for (std::size_t row = 0; row < m_; ++row) {
      for (std::size_t column = 0; column < m_; ++column)
        basis[(row + 1) * order + column + 1] = cholesky_[column * m_ + row];
    }
  }
  const auto basis_inverse = inverse_of(basis, order);
  if (!basis_inverse) throw InputError("manifold: the form is degenerate");
  for (const auto& generator : json.at("generators")) {
    const std::vector<double> matrix = field.matrix(generator);
    if (matrix.size() != order * order) throw InputError("manifold: a generator is not of the order of the dimension");
    add_letter(product_of(product_of(basis, matrix, order), *basis_inverse, order));
  }
  if (curvature_ != 0) return;
  for (std::size_t axis = 0; axis < m_; ++axis) {
    std::vector<double> translation = unit_matrix(order);
    translation[(axis + 1) * order] = 1;
    add_letter(translation);
  }
}

void SpaceFormManifold::read_elements(const CertificateSummary& certificate) {
  for (const auto& entry : certificate.elements) {
    const auto parent = static_cast<std::size_t>(entry.at(0));
    const std::int32_t letter = entry.at(1);
    if (parent >= elements_.size() || letter == 0 ||
        static_cast<std::size_t>(std::abs(std::int64_t{letter})) > motions_.letter_count())
      throw InputError("elements: one is no product of an earlier one and a letter");
    elements_.push_back(motions_.product(elements_[parent], motions_.letter(letter)));
  }
}

Motions::Matrix SpaceFormManifold::frame(const std::vector<double>& conformal) const {
  const std::size_t order = m_ + 1;
  double square = 0;
  for (std::size_t axis = 0; axis < m_; ++axis) square += conformal[axis] * conformal[axis];
  const double d = curvature_ * square / 4;
  Motions::Matrix result{};
  result[0] = (1 - d) / (1 + d);
  for (std::size_t row = 0; row < m_; ++row) {
    const double y = conformal[row] / (1 + d);
    result[(row + 1) * order] = y;
    result[row + 1] = -curvature_ * y;
    for (std::size_t column = 0; column < m_; ++column)
      result[(row + 1) * order + column + 1] =
          (row == column ? 1 : 0) - curvature_ * conformal[row] * conformal[column] / (2 + 2 * d);
  }
  return result;
}

SpaceFormManifold::Vector SpaceFormManifold::point_near(const std::vector<double>& net,
                                                        const std::vector<double>& tangent) const {
  double square = 0;
  for (const double entry : tangent) square += entry * entry;
  const double length = std::sqrt(square);
  Vector at_origin{1};
  double factor = 1;
  if (curvature_ != 0 && length > 0) {
    at_origin[0] = curvature_ > 0 ? std::cos(length) : std::cosh(length);
    factor = (curvature_ > 0 ? std::sin(length) : std::sinh(length)) / length;
  }
  for (std::size_t axis = 0; axis < m_; ++axis) at_origin[axis + 1] = factor * tangent[axis];
  const Motions::Matrix matrix = frame(net);
  Vector result{};
  for (std::size_t row = 0; row <= m_; ++row) {
    for (std::size_t column = 0; column <= m_; ++column)
      result[row] += matrix[row * (m_ + 1) + column] * at_origin[column];
  }
  return result;
}

/// A quantity that grows with the distance from the origin, the same for all positive multiples of x (of curvature 0:
/// for x₀ = 1).
double SpaceFormManifold::farness(const Vector& x) const {
  double square = 0;
  if (curvature_ == 0) {
    for (const double entry : cartesian(x)) square += entry * entry;
    return square;
  }
  for (std::size_t axis = 1; axis <= m_; ++axis) square += x[axis] * x[axis];
  return curvature_ > 0 ? -x[0] / std::sqrt(x[0] * x[0] + square) : square / (x[0] * x[0]);
}

std::uint32_t SpaceFormManifold::cell_sheet(const DrawnSimplex& simplex) {
  Vector centre = sum_of_vertices(simplex);
  if (curvature_ == 0) {
    for (std::size_t axis = 0; axis <= m_; ++axis) centre[axis] /= static_cast<double>(simplex.labels.size());
  }
  // The copy whose middle is nearest to the origin: by the elements of its vertices, then letter by letter.
  std::uint32_t best = 0;
  double least = farness(centre);
  const auto consider = [&](std::uint32_t motion) {
    const double value = farness(motions_.apply(motion, centre));
    if (!(value < least - 1e-9)) return false;
    best = motion;
    least = value;
    return true;
  };
  for (const std::uint32_t element : simplex.elements) consider(motions_.inverse(elements_.at(element)));
  for (bool is_nearer = true; is_nearer;) {
    is_nearer = false;
    const std::uint32_t from = best;
    for (std::size_t letter = 1; letter <= motions_.letter_count(); ++letter) {
      for (const int sign : {1, -1})
        is_nearer =
            consider(motions_.product(motions_.letter(sign * static_cast<std::int32_t>(letter)), from)) || is_nearer;
    }
  }
  return best;
}

std::string SpaceFormManifold::sheet_text(std::uint32_t sheet) const {
  std::string result;
  const std::size_t generators = motions_.letter_count() - (curvature_ == 0 ? m_ : 0);
  for (const std::int32_t letter : motions_.word(sheet)) {
    const auto number = static_cast<std::size_t>(std::abs(letter));
    const bool is_generator = number <= generators;
    result += fmt::format("{}{}{}{}", result.empty() ? "" : " ", is_generator ? "g" : "e",
                          is_generator ? number : number - generators, letter < 0 ? "^-1" : "");
  }
  return result.empty() ? "1" : result;
}

std::optional<ApproximateManifold::ChartPlace> SpaceFormManifold::in_chart(std::uint32_t i, std::uint32_t j,
                                                                           std::uint32_t element) const {
  if (curvature_ == 0) return LinearManifold::in_chart(i, j, element);
  const Vector x = motions_.apply(element, points_.at(j));
  const Motions::Matrix& matrix = to_charts_[i];
  Vector seen{};
  for (std::size_t row = 0; row <= m_; ++row) {
    for (std::size_t column = 0; column <= m_; ++column) seen[row] += matrix[row * (m_ + 1) + column] * x[column];
  }
  if (!(1 + seen[0] > 1e-9)) return std::nullopt;
  ChartPlace result{};
  double square = 0;
  for (std::size_t axis = 0; axis < m_; ++axis) {
    result[axis] = 2 * seen[axis + 1] / (1 + seen[0]);
    square += result[axis] * result[axis];
  }
  const double factor = arc_factor(curvature_ * square / 4);
  for (std::size_t axis = 0; axis < m_; ++axis) result[axis] *= factor;
  return result;
}

std::optional<SquaredEdges> SpaceFormManifold::squared_edges(const DrawnSimplex& simplex) const {
  if (curvature_ == 0) return LinearManifold::squared_edges(simplex);
  std::array<Vector, most_vertices_of_a_simplex> places{};
  for (std::size_t k = 0; k <= m_; ++k) places[k] = vertex(simplex.labels[k], simplex.elements[k]);
  return squares_between(m_ + 1, [&](std::size_t j, std::size_t k) {
    const Vector& a = places[j];
    const Vector& b = places[k];
    // 4 sin²(d/2) or 4 sinh²(d/2).
    double chord = curvature_ * (a[0] - b[0]) * (a[0] - b[0]);
    for (std::size_t axis = 1; axis <= m_; ++axis) chord += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    const double half = std::sqrt(std::max(chord, 0.0)) / 2;
    const double distance = 2 * (curvature_ > 0 ? std::asin(std::min(half, 1.0)) : std::asinh(half));
    return distance * distance;
  });
}

std::vector<DrawingModel> SpaceFormManifold::models() const {
  if (curvature_ == 0) return LinearManifold::models();
  if (curvature_ < 0) return {DrawingModel::conformal, DrawingModel::stereographic, DrawingModel::gnomonic};
  if (m_ == 2)
    return {DrawingModel::unit, DrawingModel::stereographic, DrawingModel::conformal, DrawingModel::gnomonic};
  return {DrawingModel::stereographic, DrawingModel::conformal, DrawingModel::gnomonic, DrawingModel::unit};
}

std::optional<std::vector<double>> SpaceFormManifold::drawn(DrawingModel model, const Place& place) const {
  if (curvature_ == 0) return LinearManifold::drawn(model, place);
  std::vector<double> result;
  if (model == DrawingModel::unit) {
    result.assign(place.begin() + 1, place.begin() + static_cast<std::ptrdiff_t>(m_ + 1));
    result.push_back(place[0]);
    return result;
  }
  const double divisor = model == DrawingModel::gnomonic ? place[0] : 1 + place[0];
  if (!(divisor > 1e-9)) return std::nullopt;
  for (std::size_t axis = 1; axis <= m_; ++axis) result.push_back(place[axis] / divisor);
  return result;
}

/// Elements by their words, until there are enough; of those the ones that move the origin least.
std::vector<std::uint32_t> SpaceFormManifold::nearest_copies() {
  const Vector origin{1};
  std::vector<std::uint32_t> found{0};
  for (std::size_t at = 0; at < found.size() && found.size() < most_elements; ++at) {
    for (std::size_t letter = 1; letter <= motions_.letter_count(); ++letter) {
      for (const int sign : {1, -1}) {
        const std::uint32_t next =
            motions_.product(found[at], motions_.letter(sign * static_cast<std::int32_t>(letter)));
        if (std::find(found.begin(), found.end(), next) == found.end()) found.push_back(next);
      }
    }
  }
  found.erase(found.begin());
  std::stable_sort(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) {
    return farness(motions_.apply(a, origin)) < farness(motions_.apply(b, origin)) - 1e-9;
  });
  if (found.size() > most_walls) found.resize(most_walls);
  return found;
}

/// As a function of x that is not negative where x is no farther from the origin than from its image.
SpaceFormManifold::Vector SpaceFormManifold::wall_before(const Vector& image) const {
  Vector wall{};
  if (curvature_ == 0) {
    const std::array<double, 4> there = cartesian(image);
    for (std::size_t row = 0; row < m_; ++row) {
      wall[0] += there[row] * there[row] / 2;
      for (std::size_t axis = 0; axis < m_; ++axis) wall[axis + 1] -= cholesky_[axis * m_ + row] * there[row];
    }
    return wall;
  }
  wall[0] = curvature_ * (1 - image[0]);
  for (std::size_t axis = 1; axis <= m_; ++axis) wall[axis] = -image[axis];
  return wall;
}

std::vector<std::pair<ApproximateManifold::Place, ApproximateManifold::Place>> SpaceFormManifold::domain() {
  std::vector<Vector> walls;
  for (const std::uint32_t element : nearest_copies()) walls.push_back(wall_before(motions_.apply(element, Vector{1})));
  std::vector<std::pair<Place, Place>> result;
  for (const auto& [from, to] : wires_between(walls, m_, curvature_)) {
    std::pair<Place, Place> wire;
    std::copy(from.begin(), from.end(), wire.first.begin());
    std::copy(to.begin(), to.end(), wire.second.begin());
    result.push_back(wire);
  }
  return result;
}

}  // namespace delcert
