#pragma once

#include <array>
#include <functional>

#include "tests/checker/support/certificate_text.hpp"

namespace delcert::checker_tests {

using Point = std::array<double, 4>;
using Isometry = std::array<Point, 4>;  // rows

/// A triangulated net on a space form. Everything is computed in doubles, by brute force and without error bounds: only
/// the coordinates of the points, multiples of 2^-30, are exact.
struct SpaceFormModel {
  int K = 0;
  std::size_t m = 2;
  Json manifold;  // the block of the certificate
  double injectivity_radius = 0;
  std::vector<Isometry> elements;         // in the standard basis, the identity first; all that matter
  std::vector<std::array<int, 2>> words;  // of all but the identity: a parent before it, and a letter
  std::vector<Isometry> letters;          // the generators; if it is flat, then the translations
  Point frame{1, 1, 1, 1};                // flat: coordinates are those of the standard basis divided by these
  double epsilon = 0, mu = 0, rho = 0;
  std::vector<Point> net, vectors;  // conformal coordinates of the points, perturbations
  std::vector<std::vector<Labels>> stars;

  std::size_t size() const { return net.size(); }
};

/// What a certificate of the model may state.
struct SpaceFormMargins {
  double protection = 0, thickness = 0, circumradius = 0;
  double reach = 0;
  double empty = 0, ball = 0;
  double riemannian_thickness = 0, riemannian_radius = 0;
  double least_stretch = 0, greatest_stretch = 0;
  double weight = -1;  // least sum of cotangents opposite to an edge; negative for dimension 3
};

/// A multiple of 2^-30 near x.
double dyadic(double x);

/// Conformal coordinates of the point of the linear model.
Point conformal_of(std::size_t m, const Point& x);
Point linear_of(int K, std::size_t m, const Point& a);
Point image(std::size_t m, const Isometry& g, const Point& x);
/// The distance from o.
double distance_from_origin(int K, std::size_t m, const Point& x);

/// How much transitions between patches, and charts on balls of 6 epsilon, change distances, relatively.
double transition_distortion(const SpaceFormModel& model);
double metric_distortion(const SpaceFormModel& model);

/// Moves the points at random by at most rho epsilon, anew those whose stars disagree, until all stars agree, each in
/// its own chart, or, for surfaces, in the charts of all its labels. Throws std::runtime_error if that takes too long.
void perturb_until_stars_agree(SpaceFormModel& model, std::uint64_t seed, bool in_all_charts);

/// What the stars have, with room: lower bounds are halved or so, upper ones a little larger.
SpaceFormMargins roomy_margins(const SpaceFormModel& model);

/// The document without its seal, claiming these levels.
Json certificate(const SpaceFormModel& model, const SpaceFormMargins& margins, const std::set<std::string>& levels);

}  // namespace delcert::checker_tests
