#include "kernel/theorems/reach_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "kernel/chart/ambient_grid.hpp"
#include "kernel/number/middle.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/theorems/bend_bound.hpp"

namespace delcert {

namespace {

/// Farther than this along M directions tell: only what is nearer is looked for along edges.
constexpr double most_densities = 8;
constexpr double least_pi = 3.141592;
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// What M is around one label, and which segments from there may be normal to it at both ends.
template <int m>
class Neighbourhood {
 public:
  Neighbourhood(const ZeroSet& zero_set, const GraphVertices& vertices, const std::vector<double>& density,
                double slope)
      : vertices_(vertices),
        density_(density),
        slope_(slope),
        n_(vertices.manifold.ambient()),
        q_(vertices.manifold.codimension()),
        f_(zero_set.map()),
        box_(n_),
        middle_(n_),
        value_(q_),
        derivative_(q_ * n_),
        second_(q_ * n_ * n_) {}

  struct Shape {
    double curvature = unbounded;
    double steepness = unbounded;  ///< of tangent planes against the plane of the chart
  };

  /// Of M within the density of p′_i: the graph over a disc, looked at in parts of the square about it. What is found
  /// of steepness says how high the parts have to be, the second time.
  Shape shape_at(std::uint32_t i) {
    Shape result{unbounded, slope_};
    for (int round = 0; round < 2 && result.steepness < unbounded; ++round) {
      const Interval height = Interval::exactly(result.steepness) * Interval::exactly(density_[i]);
      result = {0, 0};
      Vector<int, m> at{};
      while (true) {
        const Shape part = shape_of_part(i, at, height);
        result.curvature = std::max(result.curvature, part.curvature);
        result.steepness = std::max(result.steepness, part.steepness);
        std::size_t row = 0;
        while (row < m && ++at[row] == parts) at[row++] = 0;
        if (row == m) break;
      }
    }
    return result;
  }

  /// `excludes`, in doubles with room for their errors: those of the lengths are less than 2⁻³⁰ times that of the
  /// segment, if the points are in doubles what they are, to 2⁻⁴⁰ of it. False if it is not clear.
  bool clearly_excludes(std::uint32_t i, std::uint32_t k, double steepness) const {
    const EnclosedChart<Interval>& chart = vertices_.charts[i].enclosed();
    const Interval* p = vertices_.position(i);
    const Interval* q = vertices_.position(k);
    std::array<double, most_ambient_dimensions> offset;
    double squared = 0;
    double widths = 0;
    for (std::size_t axis = 0; axis < n_; ++axis) {
      offset[axis] = middle_of(q[axis]) - middle_of(p[axis]);
      squared += offset[axis] * offset[axis];
      widths += q[axis].upper() - q[axis].lower() + p[axis].upper() - p[axis].lower();
    }
    double across = 0;
    for (std::size_t column = 0; column < m; ++column) {
      double sum = 0;
      for (std::size_t axis = 0; axis < n_; ++axis) sum += middle_of(chart.at(axis, column)) * offset[axis];
      across += sum * sum;
    }
    const double length = std::sqrt(squared);
    if (!(widths < length * 0x1p-40)) return false;
    const double above = std::sqrt(std::max(squared - across, 0.0) + squared * 0x1p-40);
    const double radii = density_[i] + density_[k];
    return steepness * (above + radii) < std::sqrt(across) - radii - length * 0x1p-18 * (1 + steepness);
  }

  /// Whether no segment from near p′_i to near p′_k is normal to M at its first end, as it leaves too flatly.
  bool excludes(std::uint32_t i, std::uint32_t k, double steepness) const {
    if (clearly_excludes(i, k, steepness)) return true;
    const EnclosedChart<Interval>& chart = vertices_.charts[i].enclosed();
    Interval across(0);
    Interval above(0);
    for (std::size_t column = 0; column < n_; ++column) {
      const Interval apart =
          chart.coordinate(vertices_.position(k), column) - chart.coordinate(vertices_.position(i), column);
      (column < m ? across : above) += square(apart);
    }
    const Interval radii = Interval::exactly(density_[i]) + Interval::exactly(density_[k]);
    return is_proved(less(Interval::exactly(steepness) * (square_root(above) + radii), square_root(across) - radii));
  }

 private:
  static constexpr int parts = 4;

  /// With J = Df, a vector u + Nw is tangent if w = −(JN)⁻¹Ju for u along E; and the second fundamental form of a unit
  /// tangent vector t is not longer than (JN)⁻¹D²f[t, t], as N times the latter has the same image under J, and normal
  /// vectors are the shortest such.
  Shape shape_of_part(std::uint32_t i, const Vector<int, m>& at, const Interval& height) {
    const EnclosedChart<Interval>& chart = vertices_.charts[i].enclosed();
    const Interval step = Interval::exactly(density_[i]) / Interval(parts);
    const auto around = [&](std::size_t k) { return (k < m ? step : height) * Interval::between(-1, 1); };
    std::vector<Interval> offset(n_);  // of the part from its middle, in the frame of the chart
    for (std::size_t axis = 0; axis < n_; ++axis) {
      Interval middle = vertices_.position(i)[axis];
      for (std::size_t k = 0; k < m; ++k) middle += chart.at(axis, k) * (step * Interval(2 * at[k] - parts + 1));
      middle_[axis] = middle;
      box_[axis] = middle;
      for (std::size_t k = 0; k < n_; ++k) box_[axis] += chart.at(axis, k) * around(k);
    }
    for (std::size_t k = 0; k < n_; ++k) offset[k] = around(k);
    Dense<Interval> along(q_ * n_);
    if (!f_.first(middle_.data(), value_.data(), along.data()) ||
        !f_.second(box_.data(), value_.data(), derivative_.data(), second_.data()))
      return {};
    // All in the frame of the chart, so that what is flat stays flat.
    along = times_frame(chart, along);
    Dense<Interval> bends = in_frame(chart, second_);
    for (std::size_t entry = 0; entry < q_ * n_; ++entry) {
      for (std::size_t k = 0; k < n_; ++k) along[entry] += bends[entry * n_ + k] * offset[k];
    }
    Dense<double> rough(q_ * q_);
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t column = 0; column < q_; ++column)
        rough[row * q_ + column] = middle_of(along[row * n_ + m + column]);
    }
    const auto inverse = inverse_of(std::move(rough), q_);
    if (!inverse) return {};
    // Rows of A·J·T and A·D²f, A nearly (JN)⁻¹.
    along = weighted(*inverse, along, n_);
    Interval tangential(0);
    Interval defect(0);
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t column = 0; column < n_; ++column) {
        const Interval& entry = along[row * n_ + column];
        if (column < m) tangential += square(entry);
        if (column >= m) defect += square(entry - Interval(column - m == row ? 1 : 0));
      }
    }
    const Interval rest = Interval(1) - square_root(defect);
    if (!is_proved(less(Interval(0), rest))) return {};
    const Interval steepness = square_root(tangential) / rest;
    bends = weighted(*inverse, bends, n_ * n_);
    Interval squared(0);
    for (std::size_t row = 0; row < q_; ++row) squared += square(bend_bound<m>(&bends[row * n_ * n_], n_, steepness));
    return {(square_root(squared) / rest).upper(), steepness.upper()};
  }

  [[nodiscard]] Dense<Interval> times_frame(const EnclosedChart<Interval>& chart, const Dense<Interval>& rows) const {
    Dense<Interval> result(rows.size(), Interval(0));
    for (std::size_t row = 0; row < rows.size(); row += n_) {
      for (std::size_t column = 0; column < n_; ++column) {
        for (std::size_t axis = 0; axis < n_; ++axis) result[row + column] += rows[row + axis] * chart.at(axis, column);
      }
    }
    return result;
  }
  [[nodiscard]] Dense<Interval> weighted(const Dense<double>& weights, const Dense<Interval>& rows,
                                         std::size_t width) const {
    Dense<Interval> result(q_ * width, Interval(0));
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t b = 0; b < q_; ++b) {
        const Interval weight = Interval::exactly(weights[row * q_ + b]);
        for (std::size_t at = 0; at < width; ++at) result[row * width + at] += weight * rows[b * width + at];
      }
    }
    return result;
  }
  /// TᵀBT for symmetric N×N matrices B, one after the other.
  [[nodiscard]] Dense<Interval> in_frame(const EnclosedChart<Interval>& chart, const Dense<Interval>& forms) const {
    const Dense<Interval> right = times_frame(chart, forms);
    Dense<Interval> result(forms.size(), Interval(0));
    for (std::size_t form = 0; form < forms.size(); form += n_ * n_) {
      for (std::size_t k = 0; k < n_; ++k) {
        for (std::size_t axis = 0; axis < n_; ++axis) {
          for (std::size_t l = 0; l < n_; ++l)
            result[form + k * n_ + l] += chart.at(axis, k) * right[form + axis * n_ + l];
        }
      }
    }
    return result;
  }

  const GraphVertices& vertices_;
  const std::vector<double>& density_;
  double slope_;
  std::size_t n_, q_;
  FormulaEvaluation<Interval> f_;
  std::vector<Interval> box_, middle_, value_, derivative_, second_;
};

/// The edges of a complex, with upper bounds of how long shortest curves in M between their ends are.
template <int m>
class CurvesAlongEdges {
 public:
  CurvesAlongEdges(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices, const Rational& slope)
      : edges_(vertices.charts.size()), length_(edges_.size(), unbounded) {
    const RoundingGuard guard;
    const Interval stretch = square_root(Interval(1) + square(scalar_from<Interval>(slope)));
    for (const LabelSimplex<m>& simplex : simplices) {
      for (const std::uint32_t i : simplex) {
        for (const std::uint32_t k : simplex) {
          if (i != k) edges_[i].push_back({k, 0});
        }
      }
    }
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      std::sort(edges_[i].begin(), edges_[i].end());
      edges_[i].erase(std::unique(edges_[i].begin(), edges_[i].end()), edges_[i].end());
      const EnclosedChart<Interval>& chart = vertices.charts[i].enclosed();
      for (auto& [k, length] : edges_[i]) {
        Interval squared(0);
        for (std::size_t column = 0; column < m; ++column)
          squared +=
              square(chart.coordinate(vertices.position(k), column) - chart.coordinate(vertices.position(i), column));
        length = (stretch * square_root(squared)).upper();
      }
    }
  }

  /// The labels to which curves from i shorter than `most` lead, with their lengths, by Dijkstra's algorithm. Needs a
  /// `RoundingGuard`.
  std::vector<std::pair<std::uint32_t, double>> from(std::uint32_t i, double most) {
    std::vector<std::pair<double, std::uint32_t>> heap{{0.0, i}};
    std::vector<std::pair<std::uint32_t, double>> result;
    std::vector<std::uint32_t> touched{i};
    length_[i] = 0;
    while (!heap.empty()) {
      std::pop_heap(heap.begin(), heap.end(), std::greater<>());
      const auto [length, at] = heap.back();
      heap.pop_back();
      if (length > length_[at]) continue;
      result.emplace_back(at, length);
      for (const auto& [next, edge] : edges_[at]) {
        const double there = (Interval::exactly(length) + Interval::exactly(edge)).upper();
        if (there >= most || there >= length_[next]) continue;
        if (length_[next] == unbounded) touched.push_back(next);
        length_[next] = there;
        heap.emplace_back(there, next);
        std::push_heap(heap.begin(), heap.end(), std::greater<>());
      }
    }
    for (const std::uint32_t label : touched) length_[label] = unbounded;
    return result;
  }

 private:
  std::vector<std::vector<std::pair<std::uint32_t, double>>> edges_;
  std::vector<double> length_;  ///< scratch
};

}  // namespace

template <int m>
ReachBound bound_reach(const ZeroSet& zero_set, const GraphVertices& vertices,
                       const std::vector<LabelSimplex<m>>& simplices, const std::vector<double>& density,
                       const Rational& slope, double greatest_length, const Progress& progress) {
  using Shape = typename Neighbourhood<m>::Shape;
  const std::size_t n = vertices.manifold.ambient();
  const std::size_t labels = vertices.charts.size();
  const double greatest_slope = [&slope] {
    const RoundingGuard guard;
    return scalar_from<Interval>(slope).upper();
  }();
  ReachBound result;
  std::vector<Shape> shapes;
  in_parts(
      "measuring the curvature", labels, progress,
      [&](std::size_t first, std::size_t last) {
        const RoundingGuard guard;
        Neighbourhood<m> at(zero_set, vertices, density, greatest_slope);
        std::vector<Shape> found;
        for (std::size_t i = first; i < last; ++i) found.push_back(at.shape_at(static_cast<std::uint32_t>(i)));
        return found;
      },
      [&](std::vector<Shape> found) {
        for (const Shape& shape : found) result.curvature = std::max(result.curvature, shape.curvature);
        shapes.insert(shapes.end(), found.begin(), found.end());
      });
  if (!(result.curvature < unbounded)) return result;
  const double widest = 2 * *std::max_element(density.begin(), density.end());
  // Rounded downwards: what is shorter than this has been looked at.
  const double looked_at = std::min(greatest_length, 2 / result.curvature) * (1 - 0x1p-40);
  AmbientGrid grid(n, std::max(looked_at, widest));
  for (std::uint32_t label = 0; label < labels; ++label) {
    std::vector<double> x(n);
    for (std::size_t axis = 0; axis < n; ++axis) x[axis] = middle_of(vertices.position(label)[axis]);
    grid.insert(x.data());
  }
  result.bottleneck = looked_at;
  // What is near along M is no bottleneck: a shortest curve of length ℓ < π/κ has ⟨y − x, tangent at x⟩ ≥ sin(κℓ)/κ.
  const CurvesAlongEdges<m> curves(vertices, simplices, slope);
  const double turn = least_pi / result.curvature * (1 - 0x1p-40);
  in_parts(
      "looking for bottlenecks", labels, progress,
      [&](std::size_t first, std::size_t last) {
        const RoundingGuard guard;
        const Neighbourhood<m> at(zero_set, vertices, density, greatest_slope);
        CurvesAlongEdges<m> along = curves;
        double least = unbounded;
        for (auto i = static_cast<std::uint32_t>(first); i < last; ++i) {
          std::vector<std::uint32_t> near;
          for (const auto& [k, length] :
               along.from(i, std::min({turn, looked_at + widest, most_densities * density[i]}))) {
            const Interval sum =
                Interval::exactly(length) + Interval::exactly(density[i]) + Interval::exactly(density[k]);
            if (sum.upper() < turn) near.push_back(k);
          }
          std::sort(near.begin(), near.end());
          // Positions are enclosed to far less than this.
          grid.visit(grid[i], (looked_at + widest) * (1 + 0x1p-20), [&](std::uint32_t k, double squared) {
            if (std::binary_search(near.begin(), near.end(), k) || at.excludes(i, k, shapes[i].steepness)) return false;
            const Interval length = square_root(Interval::exactly(squared)) * Interval::exactly(1 - 0x1p-20) -
                                    Interval::exactly(density[i]) - Interval::exactly(density[k]);
            least = std::min(least, std::max(length.lower(), 0.0));
            return false;
          });
        }
        return least;
      },
      [&](double least) { result.bottleneck = std::min(result.bottleneck, least); });
  result.reach = std::min(1 / result.curvature, result.bottleneck / 2) * (1 - 0x1p-40);
  return result;
}

template ReachBound bound_reach<1>(const ZeroSet&, const GraphVertices&, const std::vector<LabelSimplex<1>>&,
                                   const std::vector<double>&, const Rational&, double, const Progress&);
template ReachBound bound_reach<2>(const ZeroSet&, const GraphVertices&, const std::vector<LabelSimplex<2>>&,
                                   const std::vector<double>&, const Rational&, double, const Progress&);
template ReachBound bound_reach<3>(const ZeroSet&, const GraphVertices&, const std::vector<LabelSimplex<3>>&,
                                   const std::vector<double>&, const Rational&, double, const Progress&);

}  // namespace delcert
