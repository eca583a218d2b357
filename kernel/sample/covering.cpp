#include "kernel/sample/covering.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "kernel/chart/net_grid.hpp"
#include "kernel/number/ladder.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/random/counter_random.hpp"
#include "kernel/sample/hull_distance.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "kernel/stars/approximate_sphere.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

template <class S, int m>
Vector<S, m> moved(Vector<S, m> x, const Shift<m>& shift) {
  for (std::size_t axis = 0; axis < m; ++axis) x[axis] += S(shift[axis]);
  return x;
}

template <int m>
std::string named(const LiftedSimplex<m>& simplex) {
  std::string result = "{";
  for (const auto& vertex : simplex) result += (result.size() > 1 ? ", " : "") + std::to_string(vertex.index);
  return result + "}";
}

/// det of the edge vectors from the first vertex.
template <class S, int m>
S determinant(const std::array<Vector<S, m>, corners<m>>& vertices) {
  std::array<Vector<S, m>, static_cast<std::size_t>(m)> edges;
  for (std::size_t k = 2; k <= m; ++k) edges[k - 2] = difference(vertices[k], vertices[0]);
  return pairing(wedge(edges), difference(vertices[1], vertices[0]));
}

template <class S, int m>
std::array<Vector<S, m>, corners<m>> positions(const PointSet<m>& net, const LiftedSimplex<m>& simplex) {
  std::array<Vector<S, m>, corners<m>> result;
  for (std::size_t corner = 0; corner < corners<m>; ++corner) {
    result[corner] = moved<S, m>(net.template coordinates<S>(Label(simplex[corner].index)), simplex[corner].shift);
  }
  return result;
}

/// The smallest ball about the circumcentre of a face that holds all vertices: any centre is a witness, so it may be
/// computed without error bounds; the radius is bounded from above. Precondition: rounding to nearest.
template <int m>
std::pair<Vector<double, m>, double> enclosing_ball(const MetricOn<PlainDouble, m>& plain,
                                                    const MetricOn<Filter, m>& filter, const PointSet<m>& net,
                                                    const LiftedSimplex<m>& simplex, double good_enough) {
  std::array<Vector<double, m>, corners<m>> approximate;
  for (std::size_t corner = 0; corner < corners<m>; ++corner) {
    approximate[corner] = net.approximate(Label(simplex[corner].index));
    for (std::size_t axis = 0; axis < m; ++axis) approximate[corner][axis] += simplex[corner].shift[axis];
  }
  std::pair<Vector<double, m>, double> best{{}, std::numeric_limits<double>::infinity()};
  for (unsigned face = (1U << corners<m>)-1; face > 0; --face) {
    std::vector<Vector<double, m>> vertices;
    for (std::size_t corner = 0; corner < corners<m>; ++corner) {
      if ((face >> corner & 1U) != 0) vertices.push_back(approximate[corner]);
    }
    if (vertices.size() < 2) continue;
    const auto sphere = approximate_sphere<m>(plain, vertices);
    if (!std::isfinite(sphere.squared_radius) || sphere.squared_radius >= best.second) continue;
    const FilterGuard guard;
    Vector<Filter, m> centre;
    for (std::size_t axis = 0; axis < m; ++axis) centre[axis] = Filter::exactly(sphere.centre[axis]);
    double farthest = 0;
    for (const auto& vertex : positions<Filter, m>(net, simplex)) {
      farthest = std::max(farthest, filter.squared_norm(difference(vertex, centre)).upper());
    }
    if (farthest < best.second) best = {sphere.centre, farthest};
    if (best.second <= good_enough) break;
  }
  return best;
}

/// The least unit of a vertex.
template <int m>
double unit_of(const LiftedSimplex<m>& simplex, std::span<const double> units) {
  double result = 1;
  if (units.empty()) return result;
  for (const Lift<m>& vertex : simplex) result = std::min(result, units[vertex.index]);
  return result;
}

/// Displaced coordinates are on the grid of nets: in a Cartesian frame cospherical points are then triangulated the
/// same way in every copy, in others nearly always.
constexpr double jitter = 0x1p-32;
constexpr std::uint32_t most_displacements = 4;

template <int m>
std::vector<Vector<double, m>> jittered(const PointSet<m>& net, std::uint32_t attempt) {
  std::vector<Vector<double, m>> points = net.approximate_all();
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    CounterRandom random(0, RandomPurpose::jitter, index, attempt);
    for (double& coordinate : points[index]) {
      coordinate = on_net_grid(coordinate + jitter * (2 * random.next_unit() - 1));
    }
  }
  return points;
}

/// Whether nothing of the simplex is in the open ball of this radius about the origin: by a vertex or by its enclosing
/// ball where that is clear, otherwise exactly.
template <int m>
bool is_outside_ball(const Rational& radius, const PointSet<m>& net, const LiftedSimplex<m>& simplex,
                     const Vector<double, m>& centre, double squared_radius) {
  constexpr double slack = 1 + 0x1p-30;
  const double approximate_radius = approximate_double(radius);
  const double reach = (approximate_radius + std::sqrt(squared_radius)) * slack;
  if (pairing(centre, centre) > reach * reach) return true;
  std::vector<Vector<Rational, m>> vertices;
  for (const auto& vertex : simplex) {
    const auto position = net.approximate(Label(vertex.index));
    if (pairing(position, position) * slack < approximate_radius * approximate_radius) return false;
    vertices.push_back(net.exact(Label(vertex.index)));
  }
  return hull_is_outside_ball<m>(vertices, radius);
}

template <int m>
struct SignedFace {
  std::array<std::uint32_t, static_cast<std::size_t>(m)> labels;
  int sign;
  std::uint32_t simplex;
};

/// +1 or −1 as the permutation that sorts the labels is even or odd; sorts them.
template <std::size_t count>
int sort_with_sign(std::array<std::uint32_t, count>& labels) {
  int sign = 1;
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t j = i; j > 0 && labels[j] < labels[j - 1]; --j) {
      std::swap(labels[j], labels[j - 1]);
      sign = -sign;
    }
  }
  return sign;
}

/// The boundary of the chain: faces whose signs do not cancel, with a simplex that has them.
template <int m>
std::vector<SignedFace<m>> boundary(const std::vector<LiftedSimplex<m>>& simplices, std::size_t labels) {
  const auto for_faces = [&](const auto& visit) {
    for (std::uint32_t at = 0; at < simplices.size(); ++at) {
      for (std::size_t omitted = 0; omitted < corners<m>; ++omitted) {
        SignedFace<m> face;
        face.simplex = at;
        std::size_t next = 0;
        for (std::size_t corner = 0; corner < corners<m>; ++corner) {
          if (corner != omitted) face.labels[next++] = simplices[at][corner].index;
        }
        face.sign = sort_with_sign(face.labels) * (omitted % 2 == 0 ? 1 : -1);
        visit(face);
      }
    }
  };
  // Those of each least label together.
  std::vector<std::size_t> begin(labels + 1, 0);
  for_faces([&](const SignedFace<m>& face) { ++begin[face.labels[0] + std::size_t{1}]; });
  for (std::size_t label = 0; label < labels; ++label) begin[label + 1] += begin[label];
  std::vector<SignedFace<m>> faces(begin.back());
  std::vector<std::size_t> place(begin.begin(), begin.end() - 1);
  for_faces([&](const SignedFace<m>& face) { faces[place[face.labels[0]]++] = face; });
  const auto left_of = [&](std::size_t first_label, std::size_t last_label) {
    std::vector<SignedFace<m>> left;
    for (std::size_t label = first_label; label < last_label; ++label) {
      const auto at = [&](std::size_t index) { return faces.begin() + static_cast<std::ptrdiff_t>(begin[index]); };
      std::sort(at(label), at(label + 1), [](const auto& a, const auto& b) { return a.labels < b.labels; });
      for (auto first = at(label), last = first; first != at(label + 1); first = last) {
        int total = 0;
        for (; last != at(label + 1) && last->labels == first->labels; ++last) total += last->sign;
        if (total != 0) left.push_back(*first);
      }
    }
    return left;
  };
  std::vector<SignedFace<m>> result;
  in_parts<1024>("measure density", labels, no_progress(), left_of, [&](const std::vector<SignedFace<m>>& left) {
    result.insert(result.end(), left.begin(), left.end());
  });
  return result;
}

template <int m>
void certify_torus_degree(const PointSet<m>& net, const std::vector<LiftedSimplex<m>>& simplices) {
  const FilterGuard guard;
  Filter total(0);
  for (const auto& simplex : simplices) total += determinant<Filter, m>(positions<Filter, m>(net, simplex));
  int factorial = 1;
  for (int k = 2; k <= m; ++k) factorial *= k;
  // A cycle has an integer degree, total / m!: strictly between 0 and 2 it is 1.
  if (!is_proved(less(Filter(0), total)) || !is_proved(less(total, Filter(2 * factorial)))) {
    throw Rejection("density: the simplices of the net do not cover the torus exactly once");
  }
}

template <int m>
void certify_ball_degree(const FlatSpace<m>& space, const PointSet<m>& net,
                         const std::vector<LiftedSimplex<m>>& simplices) {
  const auto exact = space.metric.template on<Rational>();
  bool starts = false;
  for (const auto& simplex : simplices) {
    const auto sign_below = [&]<class S>() { return less(determinant<S, m>(positions<S, m>(net, simplex)), S(0)); };
    if (!is_refuted(decide(sign_below))) throw Rejection("density: net simplex " + named<m>(simplex) + " is inverted");
    if (starts) continue;
    const auto vertices = positions<Rational, m>(net, simplex);
    starts = determinant<Rational, m>(vertices) > Rational(0) &&
             std::any_of(vertices.begin(), vertices.end(),
                         [&](const auto& vertex) { return exact.squared_norm(vertex) < square(*space.ball_radius); });
  }
  if (!starts) throw Rejection("density: no net simplex has a vertex in the ball");
}

/// So many simplices of a torus are measured in one thread.
constexpr std::size_t simplices_in_a_part = 1024;

/// Of simplices that follow each other.
template <int m>
struct CoveringPart {
  double covering = 0;  ///< a bound of their squared radii, in squares of units
  double farthest = 0;  ///< the greatest squared radius of a ball about a point of the space
  Vector<double, m> farthest_centre{};
  std::vector<LiftedSimplex<m>> simplices;  ///< those that are needed, oriented
};

/// With a determinant that is not negative, of the points that the simplices were proposed for.
template <int m>
LiftedSimplex<m> oriented(LiftedSimplex<m> simplex, const std::vector<Vector<double, m>>& points) {
  std::array<Vector<PlainDouble, m>, corners<m>> vertices;
  for (std::size_t corner = 0; corner < corners<m>; ++corner) {
    const Lift<m>& lift = simplex[corner];
    for (std::size_t axis = 0; axis < m; ++axis)
      vertices[corner][axis] = PlainDouble::exactly(points[lift.index][axis] + lift.shift[axis]);
  }
  if (determinant<PlainDouble, m>(vertices).lower() < 0) std::swap(simplex[m - 1], simplex[m]);
  return simplex;
}

template <int m>
CoveringPart<m> covered_by(const FlatSpace<m>& space, const PointSet<m>& net,
                           const std::vector<Vector<double, m>>& proposal_points,
                           std::span<const LiftedSimplex<m>> proposed, std::span<const double> units) {
  const auto plain = space.metric.template on<PlainDouble>();
  const auto filter = [&] {
    const FilterGuard guard;
    return space.metric.template on<Filter>();
  }();
  const double ball = space.box_radius().value_or(0);
  CoveringPart<m> result;
  for (const auto& simplex : proposed) {
    const double squared_unit = unit_of<m>(simplex, units) * unit_of<m>(simplex, units);  // exact
    const auto [centre, squared_radius] =
        enclosing_ball<m>(plain, filter, net, simplex, result.covering * squared_unit);
    if (!space.is_torus() && is_outside_ball<m>(*space.ball_radius, net, simplex, centre, squared_radius)) continue;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    result.covering = std::max(
        result.covering, squared_unit == 1 ? squared_radius : std::nextafter(squared_radius / squared_unit, infinity));
    if (squared_radius > result.farthest && (space.is_torus() || pairing(centre, centre) <= ball * ball)) {
      result.farthest = squared_radius;
      result.farthest_centre = centre;
    }
    result.simplices.push_back(oriented<m>(simplex, proposal_points));
  }
  return result;
}

}  // namespace

template <int m>
Covering<m> certified_covering(const FlatSpace<m>& space, const PointSet<m>& net,
                               const std::vector<Vector<double, m>>& proposal_points,
                               const std::vector<LiftedSimplex<m>>& proposed, std::span<const double> units) {
  Covering<m> result;
  double covering = 0;
  double farthest = 0;
  result.simplices.reserve(proposed.size());
  // Of a ball, which simplices are needed may depend on what was measured before.
  const std::size_t part_size = space.is_torus() ? simplices_in_a_part : std::max<std::size_t>(proposed.size(), 1);
  in_parts<1>(
      "measure density", (proposed.size() + part_size - 1) / part_size, no_progress(),
      [&](std::size_t part, std::size_t) {
        const std::size_t first = part * part_size;
        const std::size_t count = std::min(part_size, proposed.size() - first);
        return covered_by<m>(space, net, proposal_points, std::span(proposed).subspan(first, count), units);
      },
      [&](const CoveringPart<m>& part) {
        covering = std::max(covering, part.covering);
        if (part.farthest > farthest) {
          farthest = part.farthest;
          result.farthest_centre = part.farthest_centre;
        }
        result.simplices.insert(result.simplices.end(), part.simplices.begin(), part.simplices.end());
      });
  if (!std::isfinite(covering) || covering == 0) throw Rejection("density: no simplex of the net could be measured");
  result.radius_upper = square_root_upper(Rational::exactly(covering), 60);

  const auto rim = boundary<m>(result.simplices, net.size());
  if (space.is_torus()) {
    if (!rim.empty())
      throw Rejection("density: net simplex " + named<m>(result.simplices[rim[0].simplex]) + " has a free face");
    certify_torus_degree<m>(net, result.simplices);
    return result;
  }
  for (const auto& face : rim) {
    std::vector<Vector<Rational, m>> vertices;
    for (const auto label : face.labels) vertices.push_back(net.exact(Label(label)));
    if (!hull_is_outside_ball<m>(vertices, *space.ball_radius)) {
      throw Rejection("density: the net does not reach beyond the ball at net simplex " +
                      named<m>(result.simplices[face.simplex]));
    }
  }
  certify_ball_degree<m>(space, net, result.simplices);
  return result;
}

/// On a torus copies of displaced points may disagree about a cospherical set; the next displacement decides
/// differently.
template <int m>
Covering<m> cover_net(const FlatSpace<m>& space, const PointSet<m>& net, double usual, std::span<const double> units,
                      const std::vector<LiftedSimplex<m>>& known) {
  if (!known.empty()) {
    try {
      return certified_covering<m>(space, net, net.approximate_all(), known, units);
    } catch (const Rejection&) {  // another triangulation may cover
    }
  }
  for (std::uint32_t attempt = 0;; ++attempt) {
    const auto points = jittered(net, attempt);
    const auto proposed = propose_delaunay<m>(space, points, usual);
    try {
      return certified_covering<m>(space, net, points, proposed, units);
    } catch (const Rejection&) {
      if (!space.is_torus() || attempt + 1 == most_displacements) throw;
    }
  }
}

#define DELCERT_INSTANTIATE(m)                                                                                \
  template Covering<m> certified_covering<m>(const FlatSpace<m>&, const PointSet<m>&,                         \
                                             const std::vector<Vector<double, m>>&,                           \
                                             const std::vector<LiftedSimplex<m>>&, std::span<const double>);  \
  template Covering<m> cover_net<m>(const FlatSpace<m>&, const PointSet<m>&, double, std::span<const double>, \
                                    const std::vector<LiftedSimplex<m>>&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
