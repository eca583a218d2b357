#include "kernel/theorems/graph_triangulation.hpp"

#include <algorithm>
#include <limits>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/topology/components.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t simplices_at_a_time = 256;
constexpr long digits_of_bounds = 12;
constexpr double least_displacement = 0x1p-60;
constexpr int most_rounds = 6;

/// A number of few digits above x, with room for readers whose enclosures are wider.
Rational with_room_above(double x) {
  const Rational wider = Rational::exactly(x) * (Rational(65) / Rational(64));
  return rounded_up(wider, binary_exponent(wider) - digits_of_bounds + 1);
}

/// What simplices say of the whole.
template <int m>
struct GraphMeasures {
  std::vector<GraphSimplex<m>> simplices;
  double displacement = 0;
  bool only_displacements_fail = true;
};

template <int m>
std::vector<GraphSimplex<m>> graph_measures_part(const GraphVertices& vertices,
                                                 const std::vector<LabelSimplex<m>>& simplices, double displacement,
                                                 std::size_t first, std::size_t last) {
  const RoundingGuard guard;
  GraphSimplexCheck<m> check(vertices);
  std::vector<GraphSimplex<m>> result;
  // Both have so few digits that the products are exact.
  for (std::size_t at = first; at < last; ++at)
    result.push_back(check.measure(simplices[at], displacement * vertices.unit(simplices[at])));
  return result;
}

template <int m>
GraphMeasures<m> graph_measures(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
                                double displacement, const Progress& progress) {
  GraphMeasures<m> result;
  in_parts<simplices_at_a_time>(
      "map simplices to the manifold", simplices.size(), progress,
      [&](std::size_t first, std::size_t last) {
        return graph_measures_part<m>(vertices, simplices, displacement, first, last);
      },
      [&](std::vector<GraphSimplex<m>> part) {
        for (const GraphSimplex<m>& one : part) {
          const double unit = vertices.unit(simplices[result.simplices.size()]);
          result.displacement = std::max(result.displacement, one.displacement / unit);
          if (one.cause && *one.cause != GraphCause::displacement) result.only_displacements_fail = false;
          result.simplices.push_back(one);
        }
      });
  return result;
}

/// Rule 5.clear.
template <int m>
class ClearLabels {
 public:
  ClearLabels(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
              const std::vector<GraphSimplex<m>>& measures, double displacement)
      : vertices_(vertices),
        simplices_(simplices),
        measures_(measures),
        displacement_(displacement),
        check_(vertices),
        shifts_(vertices.charts.size(), std::numeric_limits<double>::infinity()) {
    for (std::size_t at = 0; at < simplices.size(); ++at) {
      for (const std::uint32_t v : simplices[at]) shifts_[v] = std::min(shifts_[v], measures[at].shift);
    }
  }

  /// Whether p′_k is certainly away from what simplices without it are mapped to.
  [[nodiscard]] bool is_clear(std::uint32_t k) const {
    for (std::size_t at = 0; at < simplices_.size(); ++at) {
      const LabelSimplex<m>& simplex = simplices_[at];
      if (std::find(simplex.begin(), simplex.end(), k) != simplex.end()) continue;
      // ω_σ and what it is at k.
      const Interval around = Interval::exactly(displacement_) *
                              (Interval::exactly(vertices_.unit(simplex)) + Interval::exactly(vertices_.unit(k)));
      if (!is_far(k, at, around) && !has_other_height(k, simplex, around) && !is_beyond_a_facet(k, at)) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] bool is_far(std::uint32_t k, std::size_t at, const Interval& around) const {
    const Interval* here = vertices_.position(k);
    const Interval* there = vertices_.position(simplices_[at][0]);
    Interval squared(0);
    for (std::size_t axis = 0; axis < vertices_.manifold.ambient(); ++axis) squared += square(here[axis] - there[axis]);
    return is_proved(less(square(Interval::exactly(measures_[at].edge) + around), squared));
  }

  [[nodiscard]] bool has_other_height(std::uint32_t k, const LabelSimplex<m>& simplex, const Interval& around) const {
    for (std::size_t column = m; column < vertices_.manifold.ambient(); ++column) {
      const Interval height = check_.coordinate(simplex[0], k, column);
      bool is_above = true;
      bool is_below = true;
      for (const std::uint32_t v : simplex) {
        const Interval other = check_.coordinate(simplex[0], v, column);
        is_above = is_above && is_proved(less(other + around, height));
        is_below = is_below && is_proved(less(height + around, other));
      }
      if (is_above || is_below) return true;
    }
    return false;
  }

  /// Beyond a facet, or outside of the circumball, by more than what is moved sideways, in the chart of the least
  /// label.
  [[nodiscard]] bool is_beyond_a_facet(std::uint32_t k, std::size_t at) const {
    const LabelSimplex<m>& simplex = simplices_[at];
    const std::uint32_t j = simplex[0];
    const auto gradients = check_.gradients(j, simplex);
    if (!gradients) return false;
    double side = 0;
    for (const std::uint32_t v : simplex) side = std::max(side, check_.lateral(j, v));
    Interval lateral = Interval::exactly(side) * Interval::exactly(measures_[at].shift);
    if (!vertices_.residuals.empty())
      lateral += Interval::exactly(check_.lateral(j, k)) * Interval::exactly(shifts_[k]);
    Vector<Interval, m> place;
    for (std::size_t row = 0; row < m; ++row)
      place[row] = check_.coordinate(j, k, row) - check_.coordinate(j, simplex[0], row);
    for (std::size_t v = 0; v <= m; ++v) {
      const Vector<Interval, m>& gradient = (*gradients)[v];
      const Interval weight = pairing(gradient, place) + Interval(v == 0 ? 1 : 0);
      if (is_proved(less(weight, -lateral * square_root(pairing(gradient, gradient))))) return true;
    }
    return false;
  }

  const GraphVertices& vertices_;
  const std::vector<LabelSimplex<m>>& simplices_;
  const std::vector<GraphSimplex<m>>& measures_;
  double displacement_;
  GraphSimplexCheck<m> check_;
  std::vector<double> shifts_;  // s_k: the least of the simplices at k
};

template <int m>
std::vector<Label> unclear_components(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
                                      const std::vector<GraphSimplex<m>>& measures,
                                      const std::vector<std::uint32_t>& component, double displacement) {
  const RoundingGuard guard;
  const ClearLabels<m> labels(vertices, simplices, measures, displacement);
  std::vector<bool> is_settled(component.size());
  for (std::uint32_t k = 0; k < component.size(); ++k) {
    if (!is_settled[component[k]] && labels.is_clear(k)) is_settled[component[k]] = true;
  }
  std::vector<Label> result;
  for (std::uint32_t k = 0; k < component.size(); ++k) {
    if (component[k] == k && !is_settled[k]) result.emplace_back(k);
  }
  return result;
}

}  // namespace

template <int m>
GraphVertices graph_vertices(const SubmanifoldAtlas<m>& atlas, const PointSet<m>& points) {
  GraphVertices result{atlas.manifold(), atlas.charts(), {}, {}, atlas.radii().units()};
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const Label i(index);
    const Vector<Rational, m> home = points.exact(i);
    const auto enclosed = [&]<class S>(const auto& in_doubles_of) {
      Vector<S, m> coordinates;
      for (std::size_t axis = 0; axis < m; ++axis) coordinates[axis] = scalar_from<S>(home[axis]);
      const auto position = atlas.template position<S>(i, coordinates);
      if (!position) return false;
      for (const S& x : *position) result.positions.push_back(in_doubles_of(x));
      return true;
    };
    {
      const RoundingGuard guard;
      if (enclosed.template operator()<Interval>([](const Interval& x) { return x; })) continue;
    }
    if (!enclosed.template operator()<BigInterval>([](const BigInterval& x) { return in_doubles(x); }))
      throw Undecided("the point of label " + std::to_string(index) + " cannot be enclosed");
  }
  return result;
}
template GraphVertices graph_vertices<1>(const SubmanifoldAtlas<1>&, const PointSet<1>&);
template GraphVertices graph_vertices<2>(const SubmanifoldAtlas<2>&, const PointSet<2>&);
template GraphVertices graph_vertices<3>(const SubmanifoldAtlas<3>&, const PointSet<3>&);

GraphVertices given_vertices(const ZeroSet& zero_set, const std::vector<TangentChart>& charts) {
  GraphVertices result{zero_set, charts, {}, {}};
  FormulaEvaluation<BigInterval> evaluation(zero_set.map());
  std::vector<BigInterval> place(zero_set.ambient());
  std::vector<BigInterval> f(zero_set.codimension());
  for (const TangentChart& chart : charts) {
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      place[axis] = BigInterval(chart.data().centre[axis]);
      result.positions.push_back(in_doubles(place[axis]));
    }
    if (!evaluation.value(place.data(), f.data())) {
      throw Undecided("the equations are not certainly defined at label " + std::to_string(result.residuals.size()));
    }
    BigInterval squared(0);
    for (const BigInterval& value : f) squared += square(value);
    result.residuals.push_back(in_doubles(square_root(squared)).upper());
  }
  return result;
}

template <int m>
GraphTriangulation<m> check_graph_triangulation(const GraphVertices& vertices,
                                                const std::vector<LabelSimplex<m>>& simplices,
                                                const Progress& progress) {
  GraphTriangulation<m> result;
  // With what the points are moved by if nothing around them counts, to begin with.
  GraphMeasures<m> found = graph_measures<m>(vertices, simplices, 0, progress);
  // It is claimed to be above 0, even if M is where the simplices are.
  found.displacement = std::max(found.displacement, least_displacement);
  for (int round = 0; round < most_rounds && found.displacement > 0; ++round) {
    result.displacement = with_room_above(found.displacement);
    const double displacement = approximate_double(result.displacement);
    found = graph_measures<m>(vertices, simplices, displacement, progress);
    const bool has_room = found.displacement == 0 || with_room_above(found.displacement) <= result.displacement;
    if (has_room || !found.only_displacements_fail) break;
  }
  double contraction = 0;
  for (std::size_t at = 0; at < simplices.size(); ++at) {
    const GraphSimplex<m>& one = found.simplices[at];
    contraction = std::max(contraction, one.contraction);
    if (one.cause) result.failures.push_back({simplices[at], *one.cause});
  }
  if (!result.failures.empty()) return result;
  result.contraction = contraction > 0 ? with_room_above(contraction) : Rational::power_of_two(-digits_of_bounds);
  result.component = component_of_labels(vertices.charts.size(), simplices);
  result.simplices = std::move(found.simplices);
  result.unclear = unclear_components<m>(vertices, simplices, result.simplices, result.component,
                                         approximate_double(result.displacement));
  return result;
}

template GraphTriangulation<1> check_graph_triangulation<1>(const GraphVertices&, const std::vector<LabelSimplex<1>>&,
                                                            const Progress&);
template GraphTriangulation<2> check_graph_triangulation<2>(const GraphVertices&, const std::vector<LabelSimplex<2>>&,
                                                            const Progress&);
template GraphTriangulation<3> check_graph_triangulation<3>(const GraphVertices&, const std::vector<LabelSimplex<3>>&,
                                                            const Progress&);

}  // namespace delcert
