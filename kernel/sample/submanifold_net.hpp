#pragma once

#include <cstdint>
#include <memory>

#include "kernel/manifold/submanifold/cover_check.hpp"
#include "kernel/manifold/submanifold/submanifold_atlas.hpp"
#include "kernel/sample/sizing.hpp"
#include "support/error.hpp"

namespace delcert {

template <int m>
struct SubmanifoldNet {
  /// Centres of charts, in the order of a space-filling curve: points near M, dyadic.
  std::vector<std::vector<Rational>> centres;
  SamplingRadii radii{Rational(0)};
  /// Charts about them, which have passed.
  FittedCharts charts;
  /// In doubles, without error bounds: the greatest distance of a Voronoi vertex from its point, in the charts.
  double covering_radius = 0;
  std::uint64_t parts = 0;  ///< of the box, when it was shown to be covered
};

/// A part of the box may have zeros that no chart shows.
class UncoveredPart : public Undecided {
 public:
  using Undecided::Undecided;
};

/// A maximal Poisson-disk set of a manifold, each distance measured in the tangent plane at a point, as in
/// `metric_field_net`, by the radius that a sizing function has there: no dart is nearer to a point than its own
/// radius, and no point of M farther from all than that of a nearest one. Darts are random points of the box, taken to
/// M by Newton's method. Where parts of the box remain that no chart covers (`check_cover`), new points are tried from
/// there: so components that no dart has hit are found. The same for a seed everywhere.
///
/// The points are made in doubles; charts and cover are certified. Preconditions: the zero set has dimension m;
/// rounding to nearest.
template <int m>
class SubmanifoldSampling {
 public:
  /// Keeps a reference to the manifold. The radius: the greatest of the sizing function.
  SubmanifoldSampling(const EmbeddedManifold& manifold, const Rational& radius, Sizing sizing, std::uint64_t seed);
  ~SubmanifoldSampling();
  SubmanifoldSampling(const SubmanifoldSampling&) = delete;
  SubmanifoldSampling& operator=(const SubmanifoldSampling&) = delete;

  /// Adds points until there are enough. Throws Rejection if there are more than 2 000 000 points, or M is certainly
  /// empty; TooCoarse where charts do not fit (`fit_charts`); UncoveredPart, with its corners, if a part of the box
  /// remains from which no new point is found; another Undecided where M may go through the side of the box, or is
  /// perhaps singular.
  [[nodiscard]] SubmanifoldNet<m> complete(const Progress& progress);
  /// Halves the radius at these places, by cones. Points stay.
  void refine(const std::vector<std::vector<double>>& places);

 private:
  struct State;
  [[nodiscard]] SubmanifoldNet<m> complete_in_box(const Progress& progress);
  std::uint64_t seed_;
  std::unique_ptr<State> state_;
};

/// The same for one radius.
template <int m>
[[nodiscard]] SubmanifoldNet<m> submanifold_net(const EmbeddedManifold& manifold, const Rational& radius,
                                                std::uint64_t seed, const Progress& progress);

/// Throws UncoveredPart, with its corners, unless the charts cover the manifold (`check_cover`). Returns the
/// number of parts.
std::uint64_t require_cover(const EmbeddedManifold& manifold, const std::vector<TangentChart>& charts,
                            const Progress& progress);

}  // namespace delcert
