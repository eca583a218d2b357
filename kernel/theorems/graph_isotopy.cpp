#include "kernel/theorems/graph_isotopy.hpp"

#include <algorithm>
#include <limits>

#include "kernel/chart/ambient_grid.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/theorems/simplex_pairs.hpp"

namespace delcert {

namespace {

constexpr std::size_t rooms_at_a_time = 256, normals_at_a_time = 256;
constexpr double small_room = 0x1p-6;       // of 5i, as a part of ℓ + ω
constexpr double smallest_cosine = 0x1p-6;  // with room for readers whose enclosures are wider

/// Which labels are roomy, for level 5i: (embedded), its margin, and (lid), label by label.
template <int m>
class RoomyLabels {
 public:
  RoomyLabels(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
              const std::vector<GraphSimplex<m>>& measures, const Rational& displacement, const Rational& contraction)
      : vertices_(vertices),
        displacement_(scalar_from<Interval>(displacement)),
        reach_(reach_of(vertices, simplices, measures, displacement)),
        rest_(scalar_from<Interval>((Rational(1) - contraction) / Rational(m + 1))),
        grid_(vertices.manifold.ambient(), 2 * reach_ * middle_unit(vertices.units)),
        shifts_(vertices.charts.size()),
        altitudes_(vertices.charts.size(), std::numeric_limits<double>::infinity()),
        below_lid_(altitudes_) {
    for (const double unit : vertices.units) greatest_unit_ = std::max(greatest_unit_, unit);
    for (std::uint32_t label = 0; label < shifts_.size(); ++label) grid_.insert(place(label).data());
    for (std::size_t at = 0; at < simplices.size(); ++at) {
      for (std::size_t v = 0; v <= m; ++v) {
        const std::uint32_t label = simplices[at][v];
        shifts_[label] = std::max(shifts_[label], measures[at].shift);
        altitudes_[label] = std::min(altitudes_[label], measures[at].altitudes[v]);
        below_lid_[label] = std::min(below_lid_[label], measures[at].below_lid[v]);
      }
    }
  }

  /// ℓ + ω, in units, and a little more: places are rounded.
  [[nodiscard]] double reach() const { return reach_; }

  /// Of label i, in units, a lower bound: the margin of (embedded), or, unless (lid) holds too, minus infinity.
  [[nodiscard]] double room(const GraphSimplexCheck<m>& check, std::uint32_t i) const {
    double side = 0;
    const Interval unit = Interval::exactly(vertices_.unit(i));
    Interval around(0);  // the greatest unit of labels near
    grid_.visit(place(i).data(), reach_ * (vertices_.unit(i) + greatest_unit_), [&](std::uint32_t v, double squared) {
      const double reach = reach_ * (vertices_.unit(i) + vertices_.unit(v));
      if (squared > reach * reach * (1 + 0x1p-20)) return false;
      side = std::max(side, (Interval::exactly(check.lateral(i, v)) * Interval::exactly(shifts_[v])).upper());
      around = maximum(around, Interval::exactly(vertices_.unit(v)));
      return false;
    });
    const Interval moved = displacement_ * (Interval(2) * unit + around);
    if (!is_proved(less(moved, Interval::exactly(below_lid_[i])))) return -std::numeric_limits<double>::infinity();
    return ((rest_ * Interval::exactly(altitudes_[i]) - Interval(2) * Interval::exactly(side)) / unit).lower();
  }

 private:
  /// ℓ + ω, in units, and a little more: places are rounded.
  static double reach_of(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
                         const std::vector<GraphSimplex<m>>& measures, const Rational& displacement) {
    double edge = 0;
    for (std::size_t at = 0; at < measures.size(); ++at) {
      const Interval unit = Interval::exactly(vertices.unit(simplices[at]));
      edge = std::max(edge, (Interval::exactly(measures[at].edge) / unit).upper());
    }
    return ((Interval::exactly(edge) + scalar_from<Interval>(displacement)) * Interval::exactly(1 + 0x1p-20)).upper();
  }
  [[nodiscard]] std::array<double, 9> place(std::uint32_t label) const {
    std::array<double, 9> result{};
    for (std::size_t axis = 0; axis < vertices_.manifold.ambient(); ++axis)
      result[axis] = vertices_.position(label)[axis].lower();
    return result;
  }

  const GraphVertices& vertices_;
  Interval displacement_;
  double reach_;
  double greatest_unit_ = 1;
  Interval rest_;  // (1 − γ)/(m + 1)
  AmbientGrid grid_;
  std::vector<double> shifts_;     // the greatest s_τ of the simplices at each label
  std::vector<double> altitudes_;  // a_i
  std::vector<double> below_lid_;  // how far the star is below the lid of its label
};

/// Of labels that are not roomy: rules 5i.star and 5i.apart. First with those that would make the margin small.
template <int m>
void measure_pairs(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
                   const GraphTriangulation<m>& triangulation, const std::vector<double>& rooms, double small,
                   GraphIsotopy& result, const Progress& progress) {
  const double displacement = approximate_double(triangulation.displacement);
  for (const double least : {small, 0.0}) {
    double margin = std::numeric_limits<double>::infinity();
    std::vector<bool> is_tight;
    for (const double room : rooms) {
      is_tight.push_back(!(room > least));
      if (room > least) margin = std::min(margin, room);
    }
    if (!(margin < std::numeric_limits<double>::infinity())) margin = displacement;
    const SimplexPairs pairs =
        check_simplex_pairs<m>(vertices, simplices, triangulation.simplices, is_tight, displacement, margin, progress);
    result.margin = pairs.margin;
    result.tightest = pairs.tightest;
    result.crowded = pairs.crowded;
    if (result.crowded.empty()) return;
  }
}

/// Rule 5i.normal, of zero sets of one equation.
template <int m>
class NormalCheck {
 public:
  NormalCheck(const GraphVertices& vertices, double displacement)
      : vertices_(vertices),
        displacement_(displacement),
        check_(vertices),
        evaluation_(vertices.manifold.evaluation()) {}

  /// A lower bound of the cosines of the angles between the gradients at points of the simplex and its normal, on the
  /// side of W; −1 if nothing is known.
  [[nodiscard]] double cosine(const LabelSimplex<m>& simplex) {
    std::array<const Interval*, static_cast<std::size_t>(m) + 1> places;
    for (std::size_t v = 0; v <= m; ++v) places[v] = vertices_.position(simplex[v]);
    // Second derivatives are enclosed where level 5 does it, as readers do.
    const double displacement = displacement_ * vertices_.unit(simplex);
    if (!evaluation_->enclose(vertices_.charts[simplex[0]], places, displacement, hull_)) return -1;
    std::array<InSpace, static_cast<std::size_t>(m) + 1> edges;  // the last is not read
    for (std::size_t k = 0; k < m; ++k) {
      for (std::size_t axis = 0; axis <= m; ++axis) edges[k][axis] = places[k + 1][axis] - places[0][axis];
    }
    InSpace normal = wedge(edges);
    InSpace fibre;
    check_.fibre(simplex[0], fibre.data());
    if (is_proved(less(pairing(normal, fibre), Interval(0)))) normal = scaled(Interval(-1), normal);
    if (!is_proved(less(Interval(0), pairing(normal, fibre)))) return -1;
    double result = 1;
    for (const Dense<Interval>& gradient : hull_.matrices) {
      InSpace along;
      std::copy_n(gradient.begin(), along.size(), along.begin());
      // At points of the simplex gradients are means of these: a mean is not longer, and has the mean of the heights.
      const Interval length = square_root(pairing(along, along) * pairing(normal, normal));
      result = std::min(result, (pairing(normal, along) / length).lower());
    }
    return result;
  }

 private:
  using InSpace = Vector<Interval, m + 1>;

  const GraphVertices& vertices_;
  double displacement_;
  GraphSimplexCheck<m> check_;
  std::unique_ptr<GraphEvaluation> evaluation_;
  DerivativeHull hull_;
};

/// Of all simplices.
template <int m>
double least_cosine(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices, double displacement,
                    const Progress& progress) {
  double result = 1;
  in_parts<normals_at_a_time>(
      "normals of simplices", simplices.size(), progress,
      [&](std::size_t first, std::size_t last) {
        const RoundingGuard guard;
        NormalCheck<m> check(vertices, displacement);
        double part = 1;
        for (std::size_t at = first; at < last; ++at) part = std::min(part, check.cosine(simplices[at]));
        return part;
      },
      [&](double part) { result = std::min(result, part); });
  return result;
}

bool is_one_equation(const EmbeddedManifold& manifold) { return manifold.is_smooth() && manifold.codimension() == 1; }

}  // namespace

template <int m>
GraphIsotopy check_graph_isotopy(const GraphVertices& vertices, const std::vector<LabelSimplex<m>>& simplices,
                                 const GraphTriangulation<m>& triangulation, const Progress& progress) {
  std::optional<RoomyLabels<m>> labels;
  {
    const RoundingGuard guard;
    labels.emplace(vertices, simplices, triangulation.simplices, triangulation.displacement, triangulation.contraction);
  }
  std::vector<double> rooms;
  in_parts<rooms_at_a_time>(
      "isotopy", vertices.charts.size(), progress,
      [&](std::size_t first, std::size_t last) {
        const RoundingGuard guard;
        const GraphSimplexCheck<m> check(vertices);
        std::vector<double> part;
        for (std::size_t i = first; i < last; ++i) part.push_back(labels->room(check, static_cast<std::uint32_t>(i)));
        return part;
      },
      [&](const std::vector<double>& part) { rooms.insert(rooms.end(), part.begin(), part.end()); });
  const auto least = std::min_element(rooms.begin(), rooms.end());
  GraphIsotopy result;
  result.margin = *least;
  result.tightest = Label(static_cast<std::uint32_t>(least - rooms.begin()));
  if (result.margin > 0) return result;
  measure_pairs(vertices, simplices, triangulation, rooms, labels->reach() * small_room, result, progress);
  if (result.margin > 0 || !is_one_equation(vertices.manifold)) return result;
  const double cosine = least_cosine<m>(vertices, simplices, approximate_double(triangulation.displacement), progress);
  if (cosine > smallest_cosine) result.cosine = cosine;
  return result;
}

#define DELCERT_INSTANTIATE(m)                                                                            \
  template GraphIsotopy check_graph_isotopy<m>(const GraphVertices&, const std::vector<LabelSimplex<m>>&, \
                                               const GraphTriangulation<m>&, const Progress&);
DELCERT_INSTANTIATE(1)
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
