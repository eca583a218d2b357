#include "proofs/drawing/linear_manifold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/manifold/submanifold/dense.hpp"
#include "proofs/drawing/dirichlet_wires.hpp"
#include "proofs/drawing/manifold_json.hpp"
#include "proofs/drawing/upper_triangle.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using ManifoldJson = nlohmann::ordered_json;

/// How many of the copies of the origin are looked at for the walls between them.
constexpr std::size_t most_walls = 64;
constexpr std::size_t most_elements = 600;

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

std::vector<double> flat_matrix(const ManifoldJson& rows) {
  std::vector<double> result;
  for (const auto& row : rows) {
    for (const auto& entry : row) result.push_back(number_of(entry));
  }
  return result;
}

std::vector<double> unit_matrix(std::size_t m) {
  std::vector<double> result(m * m);
  for (std::size_t k = 0; k < m; ++k) result[k * m + k] = 1;
  return result;
}

/// tan⁻¹ √q / √q for q > 0, tanh⁻¹ √−q / √−q for q < 0.
double arc_factor(double q) {
  if (std::fabs(q) < 1e-8) return 1 - q / 3;
  const double root = std::sqrt(std::fabs(q));
  return q > 0 ? std::atan(root) / root : std::atanh(root) / root;
}

}  // namespace

LinearManifold::LinearManifold(const CertificateSummary& certificate)
    : m_(static_cast<std::size_t>(certificate.manifold.dimension.value)), motions_(m_ + 1) {
  if (m_ < 1 || m_ > 4) throw InputError("manifold: the dimension is not in 1 to 4");
  unit_ = approximate_double(certificate.parameter("sampling_radius"));
  const ManifoldJson json = manifold_json(certificate);
  gram_ = unit_matrix(m_);
  if (certificate.family == "flat-torus") {
    gram_ = flat_matrix(json.at("gram"));
  } else if (certificate.family == "euclidean-ball") {
    family_ = Family::ball;
    radius_ = number_of(json.at("radius"));
  } else if (certificate.family == "metric-field") {
    family_ = Family::metric_field;
    for (const auto& chart : certificate.charts) charts_.push_back(doubles_of(chart));
  } else {
    family_ = Family::space_form;
    curvature_ = certificate.family == "spherical" ? 1 : certificate.family == "hyperbolic" ? -1 : 0;
    read_group(certificate);
  }
  cholesky_ = cholesky_factor(gram_, m_);
  if (is_lattice()) read_translations(certificate);
  if (family_ == Family::ball) elements_ = {0};
  place_points(certificate);
}

void LinearManifold::read_translations(const CertificateSummary& certificate) {
  elements_ = {0};
  for (const auto& shift : certificate.elements) elements_.push_back(motions_.translation(shift));
}

void LinearManifold::read_group(const CertificateSummary& certificate) {
  const ManifoldJson json = manifold_json(certificate);
  const std::vector<double> interval = numbers_of(json.at("root"));
  const double root = root_of(numbers_of(json.at("field")), interval.at(0), interval.at(1));
  const auto element = [root](const ManifoldJson& polynomial) { return value_of(numbers_of(polynomial), root); };
  const auto matrix_of = [&element](const ManifoldJson& rows) {
    std::vector<double> result;
    for (const auto& row : rows) {
      for (const auto& entry : row) result.push_back(element(entry));
    }
    return result;
  };
  gram_ = matrix_of(json.at("gram"));
  const std::vector<double> lower = cholesky_factor(gram_, m_);
  const std::size_t order = m_ + 1;
  // T, to the standard basis; of curvature 0 the frame's own is kept.
  std::vector<double> basis = unit_matrix(order);
  if (curvature_ != 0) {
    basis[0] = std::sqrt(std::fabs(element(json.at("time"))));
    for (std::size_t row = 0; row < m_; ++row) {
      for (std::size_t column = 0; column < m_; ++column)
        basis[(row + 1) * order + column + 1] = lower[column * m_ + row];
    }
  }
  const auto basis_inverse = inverse_of(basis, order);
  if (!basis_inverse) throw InputError("manifold: the form is degenerate");
  const auto times = [order](const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> result(order * order);
    for (std::size_t row = 0; row < order; ++row) {
      for (std::size_t k = 0; k < order; ++k) {
        for (std::size_t column = 0; column < order; ++column)
          result[row * order + column] += a[row * order + k] * b[k * order + column];
      }
    }
    return result;
  };
  const auto add = [this, order](const std::vector<double>& letter) {
    const auto inverse = inverse_of(letter, order);
    if (!inverse) throw InputError("manifold: a generator has no inverse");
    Motions::Matrix matrix{};
    Motions::Matrix back{};
    std::copy(letter.begin(), letter.end(), matrix.begin());
    std::copy(inverse->begin(), inverse->end(), back.begin());
    motions_.add_letter(matrix, back);
  };
  for (const auto& generator : json.at("generators")) {
    const std::vector<double> matrix = matrix_of(generator);
    if (matrix.size() != order * order) throw InputError("manifold: a generator is not of the order of the dimension");
    add(times(times(basis, matrix), *basis_inverse));
  }
  if (curvature_ == 0) {
    for (std::size_t axis = 0; axis < m_; ++axis) {
      std::vector<double> translation = unit_matrix(order);
      translation[(axis + 1) * order] = 1;
      add(translation);
    }
  }
  elements_ = {0};
  for (const auto& entry : certificate.elements) {
    const auto parent = static_cast<std::size_t>(entry.at(0));
    const std::int32_t letter = entry.at(1);
    if (parent >= elements_.size() || letter == 0 ||
        static_cast<std::size_t>(std::abs(std::int64_t{letter})) > motions_.letter_count())
      throw InputError("elements: one is no product of an earlier one and a letter");
    elements_.push_back(motions_.product(elements_[parent], motions_.letter(letter)));
  }
}

void LinearManifold::place_points(const CertificateSummary& certificate) {
  for (const auto& point : certificate.net) net_.push_back(doubles_of(point));
  if (family_ == Family::metric_field) {
    const auto is_short = [this](const auto& chart) { return chart.size() != m_ * (m_ + 1) / 2; };
    if (charts_.size() != certificate.points.size() || std::any_of(charts_.begin(), charts_.end(), is_short))
      throw InputError("charts: there is not a triangular matrix for each point");
  }
  for (std::size_t label = 0; label < certificate.points.size(); ++label) {
    std::vector<double> point = doubles_of(certificate.points[label]);
    point.resize(m_);
    Vector place{1};
    if (family_ == Family::torus || family_ == Family::ball) {
      std::copy(point.begin(), point.end(), place.begin() + 1);
    } else {
      if (label >= net_.size()) throw InputError("net: there is not a point for each label");
      place = point_near(net_[label], point);
      if (family_ == Family::metric_field) {
        const std::vector<double> solution = triangle_solution(charts_[label], point);
        for (std::size_t axis = 0; axis < m_; ++axis) place[axis + 1] = net_[label][axis] + solution[axis];
      }
    }
    points_.push_back(place);
  }
}

Motions::Matrix LinearManifold::frame(const std::vector<double>& conformal) const {
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

LinearManifold::Vector LinearManifold::point_near(const std::vector<double>& net,
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

std::array<double, 4> LinearManifold::cartesian(const Vector& x) const {
  std::array<double, 4> result{};
  for (std::size_t column = 0; column < m_; ++column) {
    for (std::size_t row = column; row < m_; ++row) result[column] += cholesky_[row * m_ + column] * x[row + 1];
  }
  return result;
}

/// A quantity that grows with the distance from the origin, the same for all positive multiples of x (of curvature 0:
/// for x₀ = 1).
double LinearManifold::farness(const Vector& x) const {
  double square = 0;
  if (curvature_ == 0) {
    for (const double entry : cartesian(x)) square += entry * entry;
    return square;
  }
  for (std::size_t axis = 1; axis <= m_; ++axis) square += x[axis] * x[axis];
  return curvature_ > 0 ? -x[0] / std::sqrt(x[0] * x[0] + square) : square / (x[0] * x[0]);
}

std::uint32_t LinearManifold::cell_sheet(const DrawnSimplex& simplex) {
  if (family_ == Family::ball) return 0;
  Vector centre{};
  for (std::size_t k = 0; k < simplex.labels.size(); ++k) {
    const Vector vertex = motions_.apply(elements_.at(simplex.elements[k]), points_.at(simplex.labels[k]));
    for (std::size_t axis = 0; axis <= m_; ++axis) centre[axis] += vertex[axis];
  }
  if (is_lattice() || curvature_ == 0) {
    for (std::size_t axis = 0; axis <= m_; ++axis) centre[axis] /= static_cast<double>(simplex.labels.size());
  }
  if (is_lattice()) {
    std::vector<std::int32_t> shift;
    for (std::size_t axis = 1; axis <= m_; ++axis)
      shift.push_back(-static_cast<std::int32_t>(std::floor(centre[axis])));
    return motions_.translation(shift);
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

std::string LinearManifold::sheet_text(std::uint32_t sheet) const {
  std::string result;
  if (is_lattice()) {
    for (std::size_t axis = 1; axis <= m_; ++axis)
      result += fmt::format("{}{:.0f}", axis == 1 ? "" : " ", motions_.matrix(sheet)[axis * (m_ + 1)] + 0.0);
    return result;
  }
  if (family_ == Family::ball) return "";
  const std::size_t generators = motions_.letter_count() - (curvature_ == 0 ? m_ : 0);
  for (const std::int32_t letter : motions_.word(sheet)) {
    const auto number = static_cast<std::size_t>(std::abs(letter));
    const bool is_generator = number <= generators;
    result += fmt::format("{}{}{}{}", result.empty() ? "" : " ", is_generator ? "g" : "e",
                          is_generator ? number : number - generators, letter < 0 ? "^-1" : "");
  }
  return result.empty() ? "1" : result;
}

std::string LinearManifold::step_text(std::uint32_t from, std::uint32_t to) {
  return sheet_text(motions_.product(to, motions_.inverse(from)));
}

std::optional<ApproximateManifold::ChartPlace> LinearManifold::in_chart(std::uint32_t i, std::uint32_t j,
                                                                        std::uint32_t element) const {
  const Vector x = motions_.apply(element, points_.at(j));
  ChartPlace result{};
  if (family_ == Family::metric_field) {
    std::vector<double> difference(m_);
    for (std::size_t axis = 0; axis < m_; ++axis) difference[axis] = x[axis + 1] - net_[i][axis];
    difference = triangle_times(charts_[i], difference);
    std::copy(difference.begin(), difference.end(), result.begin());
    return result;
  }
  if (curvature_ == 0) {
    result = cartesian(x);
    if (family_ != Family::ball) return result;
    // Charts of a ball are balls of radius 9ε.
    const std::array<double, 4> centre = cartesian(points_.at(i));
    double square = 0;
    for (std::size_t axis = 0; axis < m_; ++axis)
      square += (result[axis] - centre[axis]) * (result[axis] - centre[axis]);
    return square < 81 * unit_ * unit_ ? std::optional(result) : std::nullopt;
  }
  std::vector<double> back = net_[i];
  for (double& entry : back) entry = -entry;
  const Motions::Matrix matrix = frame(back);
  Vector seen{};
  for (std::size_t row = 0; row <= m_; ++row) {
    for (std::size_t column = 0; column <= m_; ++column) seen[row] += matrix[row * (m_ + 1) + column] * x[column];
  }
  if (!(1 + seen[0] > 1e-9)) return std::nullopt;
  double square = 0;
  for (std::size_t axis = 0; axis < m_; ++axis) {
    result[axis] = 2 * seen[axis + 1] / (1 + seen[0]);
    square += result[axis] * result[axis];
  }
  const double factor = arc_factor(curvature_ * square / 4);
  for (std::size_t axis = 0; axis < m_; ++axis) result[axis] *= factor;
  return result;
}

std::optional<double> LinearManifold::squared_edge(std::uint32_t i, std::uint32_t element_i, std::uint32_t j,
                                                   std::uint32_t element_j) const {
  if (family_ == Family::metric_field || family_ == Family::ball) return std::nullopt;
  const Vector a = motions_.apply(elements_.at(element_i), points_.at(i));
  const Vector b = motions_.apply(elements_.at(element_j), points_.at(j));
  if (curvature_ == 0) {
    double square = 0;
    const std::array<double, 4> x = cartesian(a);
    const std::array<double, 4> y = cartesian(b);
    for (std::size_t axis = 0; axis < m_; ++axis) square += (x[axis] - y[axis]) * (x[axis] - y[axis]);
    return square;
  }
  // 4 sin²(d/2) or 4 sinh²(d/2).
  double chord = curvature_ * (a[0] - b[0]) * (a[0] - b[0]);
  for (std::size_t axis = 1; axis <= m_; ++axis) chord += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  const double half = std::sqrt(std::max(chord, 0.0)) / 2;
  const double distance = 2 * (curvature_ > 0 ? std::asin(std::min(half, 1.0)) : std::asinh(half));
  return distance * distance;
}

std::vector<DrawingModel> LinearManifold::models() const {
  if (curvature_ == 0) return {DrawingModel::unit};
  if (curvature_ < 0) return {DrawingModel::conformal, DrawingModel::stereographic, DrawingModel::gnomonic};
  if (m_ == 2)
    return {DrawingModel::unit, DrawingModel::stereographic, DrawingModel::conformal, DrawingModel::gnomonic};
  return {DrawingModel::stereographic, DrawingModel::conformal, DrawingModel::gnomonic, DrawingModel::unit};
}

std::optional<std::vector<double>> LinearManifold::drawn(DrawingModel model, const Place& place) const {
  Vector x{};
  std::copy(place.begin(), place.begin() + static_cast<std::ptrdiff_t>(x.size()), x.begin());
  std::vector<double> result;
  if (curvature_ == 0) {
    const std::array<double, 4> y = cartesian(x);
    return std::vector<double>(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(m_));
  }
  if (model == DrawingModel::unit) {
    result.assign(x.begin() + 1, x.begin() + static_cast<std::ptrdiff_t>(m_ + 1));
    result.push_back(x[0]);
    return result;
  }
  const double divisor = model == DrawingModel::gnomonic ? x[0] : 1 + x[0];
  if (!(divisor > 1e-9)) return std::nullopt;
  for (std::size_t axis = 1; axis <= m_; ++axis) result.push_back(x[axis] / divisor);
  return result;
}

std::vector<std::pair<ApproximateManifold::Place, ApproximateManifold::Place>> LinearManifold::domain() {
  if (is_lattice()) return unit_cell();
  return family_ == Family::ball ? sphere_around() : dirichlet_wires();
}

std::vector<std::pair<ApproximateManifold::Place, ApproximateManifold::Place>> LinearManifold::unit_cell() const {
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

std::vector<std::pair<ApproximateManifold::Place, ApproximateManifold::Place>> LinearManifold::sphere_around() const {
  std::vector<std::pair<Place, Place>> result;
  constexpr int pieces = 64;
  for (std::size_t first = 0; first < m_; ++first) {
    for (std::size_t second = first + 1; second < m_; ++second) {
      const auto at = [&](int piece) {
        const double angle = 2 * std::acos(-1.0) * piece / pieces;
        Place place{1};
        place[first + 1] = radius_ * std::cos(angle);
        place[second + 1] = radius_ * std::sin(angle);
        return place;
      };
      for (int piece = 0; piece < pieces; ++piece) result.emplace_back(at(piece), at(piece + 1));
    }
  }
  return result;
}

std::vector<std::pair<ApproximateManifold::Place, ApproximateManifold::Place>> LinearManifold::dirichlet_wires() {
  // Elements by their words, until there are enough; of those that move the origin least, the walls.
  Vector origin{1};
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
  std::vector<Vector> walls;
  for (const std::uint32_t element : found) {
    const Vector image = motions_.apply(element, origin);
    // As a function of x that is not negative where x is no farther from the origin than from its image.
    Vector wall{};
    if (curvature_ == 0) {
      const std::array<double, 4> there = cartesian(image);
      for (std::size_t row = 0; row < m_; ++row) {
        wall[0] += there[row] * there[row] / 2;
        for (std::size_t axis = 0; axis < m_; ++axis) wall[axis + 1] -= cholesky_[axis * m_ + row] * there[row];
      }
    } else {
      wall[0] = curvature_ * (1 - image[0]);
      for (std::size_t axis = 1; axis <= m_; ++axis) wall[axis] = -image[axis];
    }
    walls.push_back(wall);
  }
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
