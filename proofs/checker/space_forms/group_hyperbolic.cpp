#include <set>

#include "proofs/checker/geometry/metric.hpp"
#include "proofs/checker/space_forms/dirichlet.hpp"
#include "proofs/checker/space_forms/group.hpp"

namespace delcert::checker {
namespace {

constexpr std::size_t most_tiles = 1000000;

FieldElement trace(const FieldMatrix& a) {
  FieldElement sum;
  for (std::size_t k = 0; k < a.order(); ++k) sum = sum + a(k, k);
  return sum;
}

/// The isometry moves every point by more than 2 inj. It has the eigenvalues e^l, e^-l, l > 0 the least displacement,
/// and for m = 2 its determinant, for m = 3 either 1, -1 (determinant -1) or e^it, e^-it; then 2 cosh l is the larger
/// root of u^2 - a u + b - 2, x^4 - a x^3 + b x^2 - a x + 1 the characteristic polynomial. One that has a fixed point
/// in the space or at infinity alone has l = 0 in the same formulas.
bool moves_far(const SpaceForm& form, const FieldMatrix& g, int determinant) {
  const FieldElement a = trace(g);
  return decide_with_balls([&] {
    const Ball U = Ball(2) * Ball::apply(arb_cosh, Ball(2) * form.injectivity_radius.as<Ball>());
    if (form.m == 2) return less(U, (a - FieldElement(determinant)).enclosure());
    if (determinant < 0) return less(U, a.enclosure());
    const FieldElement b = (a * a - trace(g * g)) / FieldElement(2);
    return disjunction(less(U * U - a.enclosure() * U + b.enclosure(), Ball(2)), less(U + U, a.enclosure()));
  });
}

Vector<Interval> enclosure(const FieldVector& x) {
  Vector<Interval> result{};
  in_balls(96, [&] {
    for (std::size_t k = 0; k < x.size(); ++k) result[k] = x[k].enclosure().enclosure();
  });
  return result;
}

/// An element of the group, and which side of the tile before it was crossed.
struct Tile {
  FieldMatrix element{0};
  int determinant = 1;
  std::size_t side = 0;
};

}  // namespace

/// Tiles gamma P are met by crossing sides from P. With D the greatest distance of a vertex of P from o: those with
/// d(o, gamma o) <= r + 2D include all with d(x, gamma y) <= r for x and y in P (docs/space-forms.md). A tile is left
/// out only if it is certainly farther.
Group hyperbolic_group(const SpaceForm& form, Report& report) {
  const Dirichlet polyhedron(form);
  if (!polyhedron.fault.empty()) report.reject("group.polyhedron", [&] { return polyhedron.fault; });
  if (!report.findings.empty()) return {};
  double walked = 0;  // an upper bound of cosh d(o, gamma o)
  in_balls(128, [&] {
    const Ball D = Ball::apply(arb_acosh, polyhedron.farthest_vertex());
    walked = Ball::apply(arb_cosh, Ball(2) * (form.injectivity_radius.as<Ball>() + D)).enclosure().upper();
  });
  const std::size_t order = form.m + 1;
  std::vector<Tile> tiles{{FieldMatrix::identity(order)}};
  // o is inside of P alone: a tile is known by its centre, the first column of its element.
  const auto first_column = [&](const FieldMatrix& a) {
    FieldVector column;
    for (std::size_t k = 0; k < order; ++k) column.push_back(a(k, 0));
    return column;
  };
  std::set<FieldVector> known{first_column(tiles[0].element)};
  std::vector<FieldVector> centres;  // of the tiles beyond the sides of P
  std::vector<Vector<Interval>> enclosed;
  std::vector<int> determinants;
  for (const Side& side : polyhedron.sides) {
    enclosed.push_back(enclosure(centres.emplace_back(first_column(side.element))));
    determinants.push_back(side.element.leading_minor(order).sign());
  }
  Group group;
  group.size = std::to_string(polyhedron.sides.size()) + " sides";
  // By Poincare's theorem: a letter for each side, which is the inverse of that of the other of its pair, and a
  // relation for each cycle of ridges.
  group.letters = polyhedron.sides.size();
  const auto relate = [&](const std::vector<std::size_t>& word) {
    std::vector<std::int64_t> exponents(group.letters);
    for (const std::size_t letter : word) ++exponents[letter];
    group.relations.push_back(std::move(exponents));
  };
  for (std::size_t s = 0; s < polyhedron.sides.size(); ++s) relate({s, polyhedron.sides[s].inverse});
  for (const std::vector<std::size_t>& cycle : polyhedron.cycles) relate(cycle);
  for (std::size_t at = 0; at < tiles.size(); ++at) {
    Budget::spend(5000 * polyhedron.sides.size());
    if (tiles.size() > most_tiles) throw Undecided("too many tiles of the polyhedron about o to look at");
    const Tile tile = tiles[at];
    FieldVector row;
    for (std::size_t k = 0; k < order; ++k) row.push_back(tile.element(0, k));
    const Vector<Interval> enclosed_row = enclosure(row);
    for (std::size_t s = 0; s < polyhedron.sides.size(); ++s) {
      if (at != 0 && s == polyhedron.sides[tile.side].inverse) continue;  // where we come from
      const Interval moved = dot(enclosed_row, enclosed[s], order);
      if (moved.lower() > walked) continue;
      const FieldVector centre = tile.element * centres[s];
      // Doubles tell little in a basis that is far from orthogonal.
      if (!(moved.upper() <= walked) && enclosure(FieldVector{centre[0]})[0].lower() > walked) continue;
      if (!known.insert(centre).second) continue;
      const Tile next{tile.element * polyhedron.sides[s].element, tile.determinant * determinants[s], s};
      tiles.push_back(next);
      if (moves_far(form, next.element, next.determinant)) continue;
      report.reject("group.injectivity", [&] {
        return "an element moves a point by at most twice the injectivity radius " +
               rounded_up(form.injectivity_radius.exact);
      });
    }
  }
  group.summary = "a polyhedron with " + group.size + ", " + std::to_string(tiles.size()) + " tiles around it";
  return group;
}

}  // namespace delcert::checker
