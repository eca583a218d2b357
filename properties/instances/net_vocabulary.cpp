#include "properties/instances/net_vocabulary.hpp"

#include <algorithm>

#include "kernel/number/ladder.hpp"
#include "kernel/simplex/sphere_stack.hpp"
#include "proofs/formula/evaluation.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/net_forbidden.hpp"
#include "properties/instances/net_object.hpp"
#include "properties/instances/net_sample.hpp"
#include "properties/instances/net_star.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

template <class S>
const NetObject& net_of(const Argument<S>& argument) {
  return object_of<NetObject>(argument);
}
const NetObject& net_of(const Item& item) { return object_of<NetObject>(item); }

template <class S>
S enclosure(const Rational& lower, const Rational& upper);
template <>
Interval enclosure<Interval>(const Rational& lower, const Rational& upper) {
  return Interval::between(scalar_from<Interval>(lower).lower(), scalar_from<Interval>(upper).upper());
}
template <>
BigInterval enclosure<BigInterval>(const Rational& lower, const Rational& upper) {
  return BigInterval::between(lower, upper);
}

/// The number itself if its enclosure is a point.
std::optional<Rational> exactly(const Interval& x) {
  if (x.lower() != x.upper()) return std::nullopt;
  return Rational::exactly(x.lower());
}
std::optional<Rational> exactly(const BigInterval& x) {
  if (!x.is_bounded() || x.lower() != x.upper()) return std::nullopt;
  return x.lower();
}
std::optional<Rational> exactly(const Surd& x) { return x.rational(); }
std::optional<Rational> exactly(const Algebraic& x) {
  if (x.degree() != 1) return std::nullopt;
  return x.rational();
}

template <class S>
S root_of(const Rational& squared) {
  return square_root(scalar_from<S>(squared));
}

Rational squared_distance(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational result(0);
  for (std::size_t axis = 0; axis < a.size(); ++axis) result += square(a[axis] - b[axis]);
  return result;
}

Rational squared_separation_of(const NetObject& net) {
  return with_net_dimension(net.dimension(), [&net]<int m>() { return squared_separation<m>(net.vectors<m>()); });
}

void require_pairs(const NetObject& p, const NetObject& q) {
  if (p.size() != q.size() || p.dimension() != q.dimension()) throw InputError("two nets of different sizes");
}

std::optional<StarCells> cells_of(const NetObject& net) {
  return with_net_dimension(net.dimension(), [&net]<int m>() {
    // Where to begin: twice the distance of the nearest point holds a few at least.
    Rational nearest = squared_distance(net.points()[1], net.points()[0]);
    for (std::size_t at = 2; at < net.size(); ++at) {
      nearest = minimum(nearest, squared_distance(net.points()[at], net.points()[0]));
    }
    return star_cells<m>(net.vectors<m>(), Rational(2) * square_root_upper(nearest, 20));
  });
}

/// A type of its own for what is attached to a net.
struct Star {
  std::optional<std::vector<NetObject::Points>> cells;
};

template <class S>
const Star& star(Evaluation<S>& evaluation, const NetObject& net) {
  return evaluation.template attached<Star>(net, [&] { return Star{star_coordinates(net)}; });
}

}  // namespace

std::optional<std::vector<NetObject::Points>> star_coordinates(const NetObject& net) {
  const auto cells = cells_of(net);
  if (!cells) return std::nullopt;
  std::vector<NetObject::Points> result;
  for (const auto& cell : *cells) {
    NetObject::Points vertices;
    for (const std::uint32_t at : cell) vertices.push_back(net.points()[at]);
    std::sort(vertices.begin(), vertices.end());
    result.push_back(std::move(vertices));
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Item> star_simplices(const NetObject& net) {
  std::vector<std::vector<std::uint32_t>> simplices;
  const auto cells = cells_of(net);
  if (!cells) return {};
  const auto count = static_cast<std::size_t>(net.dimension());
  for (const auto& cell : *cells) {
    std::vector<bool> chosen(cell.size() - 1, false);
    std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(count), true);
    do {
      std::vector<std::uint32_t> simplex{cell[0]};
      for (std::size_t at = 0; at < chosen.size(); ++at) {
        if (chosen[at]) simplex.push_back(cell[at + 1]);
      }
      simplices.push_back(std::move(simplex));
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
  }
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
  std::vector<Item> result;
  for (const auto& simplex : simplices) {
    NetObject::Points vertices;
    for (const std::uint32_t at : simplex) vertices.push_back(net.points()[at]);
    result.emplace_back(std::make_shared<SimplexObject>(std::move(vertices)));
  }
  return result;
}

template <class S>
Partial<S> simplex_protection(const NetObject& net, const SimplexObject& simplex) {
  if (!simplex.has_coordinates() || simplex.ambient_dimension() != static_cast<std::size_t>(net.dimension()) ||
      simplex.dimension() != simplex.ambient_dimension()) {
    throw InputError("protection is of an m-simplex by its coordinates");
  }
  return with_net_dimension(net.dimension(), [&]<int m>() -> Partial<S> {
    const auto metric = FrameMetric<m>::cartesian().template on<Rational>();
    std::vector<Vector<Rational, m>> vertices(simplex.vertex_count());
    for (std::size_t at = 0; at < vertices.size(); ++at) {
      std::copy(simplex.points()[at].begin(), simplex.points()[at].end(), vertices[at].begin());
    }
    SphereStack<Rational, m> stack(metric);
    for (std::size_t at = 1; at < vertices.size(); ++at) {
      const auto edge = difference(vertices[at], vertices[0]);
      if (!is_proved(stack.push(edge, metric.squared_norm(edge)))) return Partial<S>::absent(Verdict::refuted);
    }
    // The nearest point to the centre decides, exactly; roots come last.
    std::optional<Rational> nearest;
    const auto centre = sum(stack.centre(), vertices[0]);
    for (const auto& point : net.vectors<m>()) {
      if (std::find(vertices.begin(), vertices.end(), point) != vertices.end()) continue;
      const Rational squared = metric.squared_norm(difference(point, centre));
      if (!nearest || squared < *nearest) nearest = squared;
    }
    if (!nearest) return Partial<S>::absent(Verdict::refuted);
    // (d² − R²)/(d + R): no digits are lost where d and R are nearly the same.
    const S sum_of_roots = root_of<S>(*nearest) + root_of<S>(stack.squared_radius());
    return S(scalar_from<S>(*nearest - stack.squared_radius()) / sum_of_roots);
  });
}

template Partial<Interval> simplex_protection<Interval>(const NetObject&, const SimplexObject&);
template Partial<BigInterval> simplex_protection<BigInterval>(const NetObject&, const SimplexObject&);
template Partial<Surd> simplex_protection<Surd>(const NetObject&, const SimplexObject&);
template Partial<Algebraic> simplex_protection<Algebraic>(const NetObject&, const SimplexObject&);

namespace {

ObjectPointer region_of_interest(const NetObject& p, const NetObject& q) {
  require_pairs(p, q);
  const Rational radius = Rational(6) * p.sampling_radius();
  NetObject::Points points;
  for (const auto& point : q.points()) {
    if (squared_distance(point, p.points()[0]) < square(radius)) points.push_back(point);
  }
  if (points.empty() || points.front() != q.points().front()) {
    throw InputError("the first point of the net is not in the region of interest");
  }
  return std::make_shared<NetObject>(std::move(points), p.sampling_radius(), Rational(0));
}

void add_measures(Vocabulary& vocabulary) {
  vocabulary.add(number_function("separation", {types::net}, "The least distance of two points of a net, a length.",
                                 "\\operatorname{sep}(#1)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                   return root_of<S>(squared_separation_of(net_of(a[0])));
                                 }));
  vocabulary.add(number_function(
      "covering_radius", {types::net},
      "The least radius of closed balls about the points of a net that cover the ball it is for, a length; enclosed by "
      "a certified triangulation, so the same on all rungs and not exact.",
      "\\operatorname{cov}(#1)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        if constexpr (std::same_as<S, Surd> || std::same_as<S, Algebraic>) {
          return Partial<S>::absent(Verdict::undecided);
        } else {
          const auto& bounds = net_of(a[0]).covering();
          if (!bounds) return Partial<S>::absent(Verdict::undecided);
          return enclosure<S>(bounds->lower, bounds->upper);
        }
      }));
  vocabulary.add(number_function(
      "displacement", {types::net, types::net},
      "The greatest distance between the points of the same number in two nets of the same size, a length.",
      "\\operatorname{disp}(#1, #2)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        const NetObject& p = net_of(a[0]);
        const NetObject& q = net_of(a[1]);
        require_pairs(p, q);
        Rational greatest(0);
        for (std::size_t at = 0; at < p.size(); ++at) {
          greatest = maximum(greatest, squared_distance(p.points()[at], q.points()[at]));
        }
        return root_of<S>(greatest);
      }));
  vocabulary.add(number_function(
      "simplices_within", {types::net, types::number},
      "How many m-simplices have all vertices at less than the given distance from the first point of a net, and that "
      "point not among them: a binomial coefficient.",
      "\\#\\mathcal S(#1, #2)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        const NetObject& net = net_of(a[0]);
        const S squared = square(std::get<S>(a[1]));
        long count = 0;
        for (std::size_t at = 1; at < net.size(); ++at) {
          const Verdict inside = less(scalar_from<S>(squared_distance(net.points()[at], net.points()[0])), squared);
          if (is_undecided(inside)) return Partial<S>::absent(inside);
          count += is_proved(inside) ? 1 : 0;
        }
        Rational binomial(1);
        for (long i = 0; i <= net.dimension(); ++i) binomial = binomial * Rational(count - i) / Rational(i + 1);
        return scalar_from<S>(count > net.dimension() ? binomial : Rational(0));
      }));
  vocabulary.add(number_function(
      "farthest_original", {types::net, types::net, types::number},
      "The greatest distance in the first net from its first point, a length, over the points that are closer than the "
      "given length to the first point in the second net.",
      "\\max_{\\lvert {#2}_j - {#2}_i\\rvert < #3}\\lvert {#1}_j - {#1}_i\\rvert",
      []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        const NetObject& p = net_of(a[0]);
        const NetObject& q = net_of(a[1]);
        require_pairs(p, q);
        const S squared = square(std::get<S>(a[2]));
        Rational greatest(0);
        for (std::size_t at = 1; at < p.size(); ++at) {
          const Verdict near = less(scalar_from<S>(squared_distance(q.points()[at], q.points()[0])), squared);
          if (is_undecided(near)) return Partial<S>::absent(near);
          if (is_proved(near)) greatest = maximum(greatest, squared_distance(p.points()[at], p.points()[0]));
        }
        return root_of<S>(greatest);
      }));
}

void add_stars(Vocabulary& vocabulary) {
  vocabulary.add(
      {"region_of_interest",
       {types::net, types::net},
       types::net,
       "Q′ of the paper: the points of the second net (P′) in the open ball of radius 6ε about the first point of "
       "the first (P), ε its sampling radius.",
       "Q'(#1, #2)",
       false,
       ItemFunction([](std::span<const Item> a) -> Item { return region_of_interest(net_of(a[0]), net_of(a[1])); })});
  vocabulary.add({"star_simplices",
                  {types::net},
                  types::simplices,
                  "The m-simplices of the Delaunay complex of a net at its first point; of more than m + 1 cospherical "
                  "points all subsets of m + 1. Empty if the first point is not well inside the convex hull.",
                  "\\operatorname{star}^m(#1)",
                  false,
                  SetFunction([](std::span<const Item> a) { return star_simplices(net_of(a[0])); })});
  vocabulary.add(truth_function("have_same_star", {types::net, types::net},
                                "The stars of the first points in the Delaunay complexes of two nets are the same, "
                                "their vertices being compared by coordinates. Exact on every rung.",
                                "\\operatorname{star}(#1) = \\operatorname{star}(#2)",
                                []<class S>(Evaluation<S>& e, Arguments<S> a) {
                                  const Star& first = star(e, net_of(a[0]));
                                  const Star& second = star(e, net_of(a[1]));
                                  // Not closed on one side only: different.
                                  if (!first.cells && !second.cells) return Verdict::undecided;
                                  if (!first.cells || !second.cells) return Verdict::refuted;
                                  return verdict_of(*first.cells == *second.cells);
                                }));
  vocabulary.add(number_function(
      "star_reach", {types::net, types::net},
      "The greatest distance, a length, of a vertex of the star of the first point in the Delaunay complex of the "
      "second net from the first point of the first net.",
      "\\max_{v \\in \\operatorname{star}(#2)}\\lvert v - {#1}_i\\rvert",
      []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
        const Star& found = star(e, net_of(a[1]));
        if (!found.cells) return Partial<S>::absent(Verdict::undecided);
        Rational greatest(0);
        for (const auto& cell : *found.cells) {
          for (const auto& v : cell) greatest = maximum(greatest, squared_distance(v, net_of(a[0]).points()[0]));
        }
        return root_of<S>(greatest);
      }));
  vocabulary.add(number_function(
      "protection", {types::net, types::simplex},
      "The least |q - C| - R, a length, over the points q of a net that are no vertices of an m-simplex with "
      "circumcentre C and radius R; undefined for a degenerate simplex.",
      "\\delta(#2; #1)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        return simplex_protection<S>(net_of(a[0]), object_of<SimplexObject>(a[1]));
      }));
  vocabulary.add(truth_function(
      "has_forbidden_configuration", {types::net, types::number, types::number, types::number},
      "Some points of a net are a forbidden configuration of Definition 2 for the flake parameter, the sampling radius "
      "and the protection given (0 < Γ₀ ≤ 1, lengths); by exact search, for numbers that the rung knows exactly.",
      "#1\\text{ has a forbidden configuration for }(#2, #3, #4)", []<class S>(Evaluation<S>&, Arguments<S> a) {
        const auto flake_parameter = exactly(std::get<S>(a[1]));
        const auto sampling_radius = exactly(std::get<S>(a[2]));
        const auto length = exactly(std::get<S>(a[3]));
        if (!flake_parameter || !sampling_radius || !length) return Verdict::undecided;
        if (*length < Rational(0)) return Verdict::refuted;
        const NetObject& net = net_of(a[0]);
        return with_net_dimension(net.dimension(), [&]<int m>() {
          return verdict_of(
              find_forbidden_configuration<m>(net.vectors<m>(), {*flake_parameter, *sampling_radius, *length})
                  .has_value());
        });
      }));
}

}  // namespace

void add_net_quantities(Vocabulary& vocabulary) {
  vocabulary.add_kind("net", NetObject::read);
  add_measures(vocabulary);
  add_stars(vocabulary);
}

}  // namespace delcert
