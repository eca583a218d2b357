#include "properties/instances/configuration_finite_map.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/simplex/circumsphere.hpp"
#include "properties/instances/exact_point.hpp"
#include "properties/instances/map_object.hpp"
#include "properties/instances/pair_distortion.hpp"

namespace delcert {

namespace {

using Points = SimplexObject::Points;

enum class Way : unsigned char { at_random, radial, off_the_hull };

ExactPoint random_vector(std::size_t dimension, Choices& choices) {
  constexpr unsigned bits = 10;
  ExactPoint result;
  for (std::size_t axis = 0; axis < dimension; ++axis) result.push_back(choices.symmetric(bits));
  return result;
}

/// About a vector orthogonal to all edges, as far as there is one; without error bounds.
ExactPoint normal_of(const Points& points) {
  const auto m = static_cast<Eigen::Index>(points.front().size());
  Eigen::MatrixXd edges(m, static_cast<Eigen::Index>(points.size()) - 1);
  for (std::size_t i = 1; i < points.size(); ++i) {
    for (Eigen::Index axis = 0; axis < m; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      edges(axis, static_cast<Eigen::Index>(i) - 1) = approximate_double(points[i][at] - points[0][at]);
    }
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> values(edges, Eigen::ComputeFullU);
  ExactPoint result;
  for (Eigen::Index axis = 0; axis < m; ++axis) result.push_back(Rational::exactly(values.matrixU()(axis, m - 1)));
  return result;
}

/// Where the vertices and the centres shall move; the centres all alike.
Points directions_of(const Points& vertices, const Points& centres, Way way, Choices& choices) {
  const std::size_t m = vertices.front().size();
  const ExactPoint nowhere(m, Rational(0));
  const ExactPoint normal = way == Way::off_the_hull ? normal_of(vertices) : nowhere;
  const bool do_centres_move = choices.happens(0.5);
  Points result;
  for (const ExactPoint& vertex : vertices) {
    const Rational amount = choices.happens(0.7) ? Rational(choices.happens(0.5) ? 1 : -1) : choices.symmetric(6);
    switch (way) {
      case Way::at_random:
        result.push_back(random_vector(m, choices));
        break;
      case Way::radial:
        result.push_back(combined(nowhere, amount, combined(vertex, Rational(-1), centres.front())));
        break;
      case Way::off_the_hull:
        result.push_back(combined(nowhere, amount, normal));
        break;
    }
  }
  const ExactPoint all_alike = !do_centres_move           ? nowhere
                               : way == Way::off_the_hull ? combined(nowhere, choices.symmetric(6), normal)
                                                          : random_vector(m, choices);
  result.resize(vertices.size() + centres.size(), all_alike);
  return result;
}

/// The largest step along the directions that changes no distance by more than ξ of it; infinity if none changes.
/// In doubles, without error bounds.
double largest_step(const Points& points, const Points& directions, double distortion) {
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ExactPoint edge = combined(points[i], Rational(-1), points[j]);
      const ExactPoint motion = combined(directions[i], Rational(-1), directions[j]);
      const double squared = approximate_double(pairing(edge, edge));
      const double along = approximate_double(pairing(edge, motion));
      const double square_of_motion = approximate_double(pairing(motion, motion));
      if (square_of_motion == 0) continue;
      // 2λ·along + λ²·|motion|² is to be between these.
      const double most = squared * distortion * (2 + distortion);
      const double least = squared * distortion * (2 - distortion);
      const double root = std::sqrt(along * along + square_of_motion * most);
      result = std::min(result, along >= 0 ? most / (along + root) : (root - along) / square_of_motion);
      if (along < 0 && along * along > square_of_motion * least) {
        result = std::min(result, least / (-along + std::sqrt(along * along - square_of_motion * least)));
      }
    }
  }
  return result;
}

}  // namespace

bool is_distorted_at_most(const ConfigurationMap::Finite& map) {
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational squared = squared_distance_between(map.points[i], map.points[j]);
      if (!lengths_differ_by_at_most(squared, squared_distance_between(map.images[i], map.images[j]),
                                     square(map.distortion) * squared)) {
        return false;
      }
    }
  }
  return true;
}

Points circumcentres_of_facets(const Points& points) {
  Points result;
  for (std::size_t left_out = 0; left_out < points.size(); ++left_out) {
    Points facet = points;
    facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(left_out));
    ExactPoint centre = circumcentre(*circumsphere(edge_gram_from_points(facet)), facet);
    if (std::find(result.begin(), result.end(), centre) == result.end()) result.push_back(std::move(centre));
  }
  return result;
}

std::optional<ConfigurationMap::Finite> finite_configuration_map(const Points& points, const Rational& distortion,
                                                                 Choices& choices) {
  const auto way = static_cast<Way>(choices.between(0, 2));
  ConfigurationMap::Finite result{points, {}, distortion};
  for (ExactPoint& centre : circumcentres_of_facets(points)) {
    // A vertex that is the circumcentre of a facet is there already.
    if (std::find(points.begin(), points.end(), centre) == points.end()) result.points.push_back(std::move(centre));
  }
  const Points centres(result.points.begin() + static_cast<std::ptrdiff_t>(points.size()), result.points.end());
  if (centres.empty()) return std::nullopt;
  const Points directions = directions_of(points, centres, way, choices);
  const double step = largest_step(result.points, directions, approximate_double(distortion));
  if (!(step > 0) || !(step < std::numeric_limits<double>::max())) return std::nullopt;
  Rational factor = Rational::exactly(step) * (Rational(1) - Rational::power_of_two(-20));
  constexpr int tries = 6;
  for (int attempt = 0; attempt < tries; ++attempt, factor = factor * Rational(3) / Rational(4)) {
    result.images = result.points;
    for (std::size_t i = 0; i < result.points.size(); ++i) {
      result.images[i] = combined(result.points[i], factor, directions[i]);
    }
    if (is_distorted_at_most(result)) return result;
  }
  return std::nullopt;
}

}  // namespace delcert
