#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/chart/sampling_radii.hpp"
#include "kernel/manifold/submanifold/dense.hpp"
#include "kernel/number/big_interval.hpp"
#include "kernel/number/interval.hpp"
#include "kernel/random/counter_random.hpp"
#include "support/progress.hpp"

namespace delcert {

class TangentChart;
struct FittedCharts;
struct CoverReport;
struct BoxPart;
struct ChordBend;

inline constexpr std::size_t most_ambient_dimensions = 9;

/// A function that vanishes in a cylinder on M alone, near a simplex with its vertices on M.
struct DerivativeHull {
  /// q×N each: the derivative, or the quotients that take its place, is within `spread` of a convex combination.
  std::vector<Dense<Interval>> matrices;
  Interval spread;
  double height = 0;  ///< an upper bound of the function's norm on the simplex
};

/// How the slopes of M change along segments in a part of a chart: e ↦ Dz[e], z the heights of M, is by arc length the
/// sum of a function with this Lipschitz constant and one of at most this size.
struct SlopeChange {
  Interval rate{0};
  Interval size{0};
};

/// What charts ask of M. Has scratch memory: one for each thread. Intervals need a `RoundingGuard`.
class GraphEvaluation {
 public:
  GraphEvaluation() = default;
  GraphEvaluation(const GraphEvaluation&) = delete;
  GraphEvaluation& operator=(const GraphEvaluation&) = delete;
  virtual ~GraphEvaluation() = default;

  /// The heights of a point of M over chart coordinates y, enclosed. None if there is none to be found. (Whether they
  /// are in the cylinder is not said.)
  [[nodiscard]] virtual std::optional<std::vector<Interval>> heights(const TangentChart& chart, const Interval* y) = 0;
  [[nodiscard]] virtual std::optional<std::vector<BigInterval>> heights(const TangentChart& chart,
                                                                        const BigInterval* y) = 0;
  /// Exactly; none also where they are not rational.
  [[nodiscard]] virtual std::optional<std::vector<Rational>> heights(const TangentChart& chart, const Rational* y) = 0;
  /// In the neighbourhood of a simplex with these vertices, N coordinates each, as wide as the displacement. False if
  /// the function is not certainly defined there. Precondition: the neighbourhood is in the cylinder of the chart.
  [[nodiscard]] virtual bool enclose(const TangentChart& chart, std::span<const Interval* const> vertices,
                                     double displacement, DerivativeHull& hull) = 0;
  /// Of M where it is in these chart coordinates, [N], and |Dz| is at most the slope. None if there is nothing to be
  /// found. Where M is not smooth that is of segments in this part only: changes in two parts say nothing of both.
  [[nodiscard]] virtual std::optional<SlopeChange> slope_change(const TangentChart& chart, const Interval* place,
                                                                const Interval& slope) = 0;
  /// How M bends about the chords from points of one box in ℝᴺ to points of another. None if that is not known, as
  /// where M is not smooth, or not a hypersurface.
  [[nodiscard]] virtual std::optional<ChordBend> chord_bend(const Interval* from, const Interval* to) = 0;
};

/// Coordinates of the points of a net of this radius are multiples of this: of a few digits fewer than doubles have.
[[nodiscard]] inline double net_step(double radius) { return std::ldexp(1.0, std::ilogb(radius) - 30); }

/// Makes points of M, in doubles, without error bounds.
class ManifoldSampler {
 public:
  ManifoldSampler() = default;
  ManifoldSampler(const ManifoldSampler&) = delete;
  ManifoldSampler& operator=(const ManifoldSampler&) = delete;
  virtual ~ManifoldSampler() = default;

  /// A place from which `project` may find a point of M, any one with some probability.
  virtual std::vector<double> dart(CounterRandom& random) = 0;
  /// Moves x to M, along the last q columns of the frame, or, without one, by a short way. False if there is none.
  virtual bool project(std::vector<double>& x, const Dense<double>* frame) = 0;
  /// q×N: nearly a basis of the normals of M at x, continuous along M. None where there is none to be found.
  virtual std::optional<Dense<double>> normals(const std::vector<double>& x) = 0;
  /// What to do about M being too curved near x, for a message.
  virtual std::string advice(const std::vector<double>& x) = 0;
  /// About the norm of the second fundamental form at x in M, the greatest |II(e, e)| of unit vectors e: exactly that
  /// for surfaces in space, and never much less. Infinite where nothing is known.
  virtual double curvature(const std::vector<double>&) { return std::numeric_limits<double>::infinity(); }
};

/// A manifold M in ℝᴺ, of dimension m = N − q, as tangent charts take it (docs/submanifolds.md). That M is a manifold
/// is for `fit_charts` and `check_cover` to find out.
class EmbeddedManifold {
 public:
  virtual ~EmbeddedManifold() = default;

  [[nodiscard]] virtual const std::string& name() const = 0;
  [[nodiscard]] virtual std::size_t ambient() const = 0;
  [[nodiscard]] virtual std::size_t codimension() const = 0;
  [[nodiscard]] std::size_t dimension() const { return ambient() - codimension(); }
  /// What it should be, from degree 0 on; empty: nothing is said.
  [[nodiscard]] virtual const std::vector<std::string>& homology() const = 0;
  /// A box that M is in: from and to, for each axis.
  [[nodiscard]] virtual const std::vector<std::array<Rational, 2>>& box() const = 0;

  /// Whether one differentiable function serves all charts: then `enclose` is asked once for a simplex, with any of its
  /// charts. Otherwise M is piecewise linear, and heights over rational places are rational.
  [[nodiscard]] virtual bool is_smooth() const = 0;
  [[nodiscard]] virtual std::unique_ptr<GraphEvaluation> evaluation() const = 0;
  /// For a net of this radius.
  [[nodiscard]] virtual std::unique_ptr<ManifoldSampler> sampler(double radius) const = 0;

  /// Charts about these points that have passed rule sub.graph with one slope. Throws Rejection if there are none.
  /// Precondition of this and the next: rounding to nearest.
  [[nodiscard]] virtual FittedCharts fit_charts(const std::vector<std::vector<Rational>>& centres,
                                                const SamplingRadii& radii, const Progress& progress) const = 0;
  /// Rule sub.cover.
  [[nodiscard]] virtual CoverReport check_cover(const std::vector<TangentChart>& charts,
                                                const Progress& progress) const = 0;
  /// A small part of the box in which M may not be a manifold, for messages. None if none is found.
  [[nodiscard]] virtual std::optional<BoxPart> singular_part() const = 0;
};

}  // namespace delcert
