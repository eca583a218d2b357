#include "proofs/drawing/manifold/tangent_manifold.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"
#include "kernel/manifold/submanifold/zero_set.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "proofs/drawing/manifold/manifold_json.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using EmbeddedJson = nlohmann::ordered_json;

std::unique_ptr<EmbeddedManifold> embedded_manifold(const EmbeddedJson& json) {
  SubmanifoldDescription description;
  description.name = json.at("name").get<std::string>();
  description.dimension = Dimension(json.at("dimension").get<int>());
  if (json.contains("mesh")) {
    TriangleMesh mesh;
    for (const auto& point : json.at("mesh")) {
      mesh.points.emplace_back();
      for (const auto& coordinate : point) mesh.points.back().push_back(parse_exact(coordinate.get<std::string>()));
    }
    for (const auto& facet : json.at("facets")) {
      mesh.triangles.push_back(facet.get<std::array<std::uint32_t, 3>>());
      for (const std::uint32_t vertex : mesh.triangles.back()) {
        if (vertex >= mesh.points.size()) throw InputError("manifold: a facet has a vertex that does not exist");
      }
    }
    return std::make_unique<PolyhedralMesh>(description.name, std::move(mesh), std::vector<std::string>{});
  }
  description.variables = json.at("variables").get<std::vector<std::string>>();
  description.equations = json.at("equations").get<std::vector<std::string>>();
  for (const auto& side : json.at("box"))
    description.box.push_back({parse_exact(side.at(0).get<std::string>()), parse_exact(side.at(1).get<std::string>())});
  return std::make_unique<ZeroSet>(std::move(description));
}

int whole_number(const Rational& x) { return static_cast<int>(std::lround(approximate_double(x))); }

/// s, A above the diagonal, Y, ϱ, ζ.
ChartData chart_data(const std::vector<Rational>& centre, const std::vector<Rational>& numbers, std::size_t m) {
  const std::size_t n = centre.size();
  const std::size_t skew = n * (n - 1) / 2;
  const std::size_t q = n - m;
  if (numbers.size() != n + skew + q * q + 2) throw InputError("charts: one has not as many numbers as it needs");
  ChartData result;
  result.centre = centre;
  auto at = numbers.begin();
  for (std::size_t k = 0; k < n; ++k) result.columns.push_back(whole_number(*at++));
  result.skew.assign(at, at + static_cast<std::ptrdiff_t>(skew));
  at += static_cast<std::ptrdiff_t>(skew);
  result.preconditioner.assign(at, at + static_cast<std::ptrdiff_t>(q * q));
  at += static_cast<std::ptrdiff_t>(q * q);
  result.radius = *at++;
  result.height = *at;
  return result;
}

EnclosedChart<double> middle_of(const EnclosedChart<Interval>& chart) {
  const auto middles = [](const std::vector<Interval>& enclosures) {
    std::vector<double> result;
    for (const Interval& x : enclosures) result.push_back(x.lower() / 2 + x.upper() / 2);
    return result;
  };
  return {chart.dimension, middles(chart.centre), middles(chart.frame), middles(chart.preconditioner)};
}

std::optional<std::vector<double>> heights_over(GraphEvaluation& evaluation, const TangentChart& chart,
                                                const std::vector<Rational>& y) {
  std::vector<double> result;
  {
    const RoundingGuard guard;
    std::vector<Interval> place;
    for (const Rational& coordinate : y) place.push_back(scalar_from<Interval>(coordinate));
    if (const auto heights = evaluation.heights(chart, place.data())) {
      for (const Interval& height : *heights) result.push_back(height.lower());
      return result;
    }
  }
  std::vector<BigInterval> place;
  for (const Rational& coordinate : y) place.emplace_back(coordinate);
  const auto heights = evaluation.heights(chart, place.data());
  if (!heights) return std::nullopt;
  for (const BigInterval& height : *heights) result.push_back(approximate_double(height.lower()));
  return result;
}

}  // namespace

TangentManifold::TangentManifold(const CertificateSummary& certificate)
    : m_(static_cast<std::size_t>(certificate.manifold.dimension.value)) {
  const EmbeddedJson json = manifold_json(certificate);
  const std::unique_ptr<EmbeddedManifold> manifold = embedded_manifold(json);
  const bool is_given = json.at("vertices").get<std::string>() == "given";
  const std::size_t labels = certificate.points.size();
  ambient_ = manifold->ambient();
  if (manifold->dimension() != m_) throw InputError("manifold: the equations are not of its dimension");
  const auto net = certificate.net();
  if (net.size() != labels || certificate.charts.size() != labels)
    throw InputError("net, charts: there is not one for each label");
  units_ = doubles_of(certificate.radii);
  if (units_.empty()) units_.assign(labels, approximate_double(certificate.parameter("sampling_radius")));
  if (units_.size() != labels) throw InputError("radii: there is not one for each label");
  const std::unique_ptr<GraphEvaluation> evaluation = manifold->evaluation();
  for (std::size_t label = 0; label < labels; ++label) {
    if (net[label].size() != ambient_ || certificate.points[label].size() != m_)
      throw InputError("label " + std::to_string(label) + " has not as many coordinates as it needs");
    const TangentChart chart(chart_data(net[label], certificate.charts[label], m_), m_);
    charts_.push_back(middle_of(chart.enclosed()));
    std::vector<double> in_chart = doubles_of(certificate.points[label]);
    const auto heights =
        is_given ? std::vector<double>(ambient_ - m_) : heights_over(*evaluation, chart, certificate.points[label]);
    if (!heights) throw InputError("label " + std::to_string(label) + ": no point of the manifold over it is found");
    in_chart.insert(in_chart.end(), heights->begin(), heights->end());
    Place place{};
    charts_.back().position(in_chart.data(), place.data());
    places_.push_back(place);
  }
}

std::optional<ApproximateManifold::ChartPlace> TangentManifold::in_chart(std::uint32_t i, std::uint32_t j,
                                                                         std::uint32_t) const {
  ChartPlace result{};
  for (std::size_t column = 0; column < m_; ++column) result[column] = charts_[i].coordinate(places_[j].data(), column);
  return result;
}

std::optional<SquaredEdges> TangentManifold::squared_edges(const DrawnSimplex& simplex) const {
  return squares_between(m_ + 1, [&](std::size_t j, std::size_t k) {
    const Place& a = places_[simplex.labels[j]];
    const Place& b = places_[simplex.labels[k]];
    double square = 0;
    for (std::size_t axis = 0; axis < ambient_; ++axis) square += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return square;
  });
}

std::optional<std::vector<double>> TangentManifold::drawn(DrawingModel, const Place& place) const {
  return std::vector<double>(place.begin(), place.begin() + static_cast<std::ptrdiff_t>(ambient_));
}

}  // namespace delcert
