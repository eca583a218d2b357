#include "proofs/checker/submanifolds/polyhedron.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace delcert::checker {
namespace {

constexpr std::size_t most_parts_of_facet = 100'000;

std::string facet_name(std::size_t facet) { return "facet " + std::to_string(facet); }
Interval at_double(double x) { return Interval::between(x, x); }
Interval joined(const Interval& a, const Interval& b) {
  return Interval::between(std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper()));
}

}  // namespace

Polyhedron::Polyhedron(const TangentCharts& charts) : charts_(charts), M_(charts.manifold()) {
  for (const Matrix<Rational>& vertex : M_.vertices) vertices_.push_back(as_numbers<Interval>(vertex));
  std::vector<Matrix<Interval>> middles;
  const Interval third = Interval(1) / Interval(3);
  for (const auto& facet : M_.facets) {
    middles.push_back(third * (vertices_[facet[0]] + vertices_[facet[1]] + vertices_[facet[2]]));
    for (const std::uint32_t v : facet)
      facet_radius_ = std::max(facet_radius_, norm_above(vertices_[v] - middles.back()));
  }
  if (!(facet_radius_ < 0x1p100)) throw Undecided("the facets of the mesh are too large");
  near_facets_ = NearPoints(middles);
}

const TangentChart<Rational>& Polyhedron::exact_chart(Label i) const {
  if (!exact_ || exact_label_ != i) {
    Budget::spend(2000);
    exact_ = std::make_unique<TangentChart<Rational>>(tangent_chart(charts_.certificate(), i));
    exact_label_ = i;
  }
  return *exact_;
}

void Polyhedron::check_closed(Report& report) const {
  const auto reject = [&](const auto& text) { report.reject("mesh.closed", text); };
  std::vector<std::tuple<std::uint32_t, std::uint32_t, bool, std::size_t>> edges;
  for (std::size_t f = 0; f < M_.facets.size(); ++f) {
    const auto& facet = M_.facets[f];
    const bool has_area = decide([&]<class N>(In<N>) {
      Corners<N> corners{};
      for (std::size_t v = 0; v < 3; ++v) {
        const Matrix<N> x = as_numbers<N>(M_.vertices[facet[v]]);
        corners[v] = {x[0], x[1], x[2]};
      }
      Verdict result = Verdict::refuted;
      for (const N& entry : normal_of(corners)) result = disjunction(result, less(N(0), square(entry)));
      return result;
    });
    if (!has_area) reject([&] { return facet_name(f) + " has no area"; });
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = facet[k], to = facet[(k + 1) % 3];
      edges.emplace_back(std::min(from, to), std::max(from, to), from < to, f);
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto is_same = [&](std::size_t a, std::size_t b) {
    return b < edges.size() && std::get<0>(edges[a]) == std::get<0>(edges[b]) &&
           std::get<1>(edges[a]) == std::get<1>(edges[b]);
  };
  for (std::size_t k = 0; k < edges.size(); k += 2) {
    if (is_same(k, k + 1) && !is_same(k, k + 2) && std::get<2>(edges[k]) != std::get<2>(edges[k + 1])) continue;
    reject([&] {
      return "the edge of vertices " + std::to_string(std::get<0>(edges[k])) + " and " +
             std::to_string(std::get<1>(edges[k])) + ", of " + facet_name(std::get<3>(edges[k])) +
             ", is not in two facets, once in each direction";
    });
    return;
  }
}

/// Whether the projection does not meet the closed disc: the origin is not in it, and each edge is farther away.
bool Polyhedron::misses_disc(Label i, const Placed& placed) const {
  return decide([&]<class N>(In<N>) {
    const Corners<N> a = corners<N>(i, placed);
    const N zero(0), squared = square(charts_.patch(i).radius.as<N>());
    Verdict left = Verdict::proved, right = Verdict::proved, far = Verdict::proved;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<N, 3>&from = a[k], &to = a[(k + 1) % 3];
      const N side = side_of(a, k, zero, zero);
      left = conjunction(left, less_equal(zero, side));
      right = conjunction(right, less_equal(side, zero));
      const N dx = to[0] - from[0], dy = to[1] - from[1], along = -(from[0] * dx + from[1] * dy);
      const N length = square(dx) + square(dy);
      far = conjunction(far, less(squared, square(from[0]) + square(from[1])));
      const Verdict foot_is_outside = disjunction(less_equal(along, zero), less_equal(length, along));
      far = conjunction(far, disjunction(foot_is_outside, less(squared * length, square(side))));
    }
    const N up = normal_of(a)[2];
    left = conjunction(left, less(zero, up));
    right = conjunction(right, less(up, zero));
    return conjunction(far, negation(disjunction(left, right)));
  });
}

bool Polyhedron::is_beyond_lid(Label i, const Placed& placed) const {
  return decide([&]<class N>(In<N>) {
    const Corners<N> a = corners<N>(i, placed);
    const N& lid = charts_.patch(i).height.as<N>();
    Verdict above = Verdict::proved, below = Verdict::proved;
    for (const auto& corner : a) {
      above = conjunction(above, less(lid, corner[2]));
      below = conjunction(below, less(lid, -corner[2]));
    }
    return disjunction(above, below);
  });
}

bool Polyhedron::is_below_lid(Label i, const Placed& placed) const {
  return decide([&]<class N>(In<N>) {
    const Corners<N> a = corners<N>(i, placed);
    const N& lid = charts_.patch(i).height.as<N>();
    Verdict result = Verdict::proved;
    for (const auto& corner : a) result = conjunction(result, conjunction(less(corner[2], lid), less(-corner[2], lid)));
    return result;
  });
}

int Polyhedron::sign(Label i, const Placed& placed) const {
  const auto is_turned = [&](int side) {
    return decide([&]<class N>(In<N>) { return less(N(0), N(side) * normal_of(corners<N>(i, placed))[2]); });
  };
  return is_turned(1) ? 1 : is_turned(-1) ? -1 : 0;
}

bool Polyhedron::is_flat(Label i, const Placed& placed) const {
  return decide([&]<class N>(In<N>) {
    const std::array<N, 3> normal = normal_of(corners<N>(i, placed));
    return less_equal(square(normal[0]) + square(normal[1]), square(M_.slope.as<N>() * normal[2]));
  });
}

Polyhedron::Position Polyhedron::position(Label i, const Placed& placed, const Quantity& x, const Quantity& y) const {
  const auto all_sides = [&](bool strictly) {
    return decide([&]<class N>(In<N>) {
      const Corners<N> a = corners<N>(i, placed);
      const N up = normal_of(a)[2], zero(0);
      Verdict result = Verdict::proved;
      for (std::size_t k = 0; k < 3; ++k) {
        const N side = up * side_of(a, k, x.as<N>(), y.as<N>());
        result = conjunction(result, strictly ? less(zero, side) : less_equal(zero, side));
      }
      return result;
    });
  };
  if (!all_sides(false)) return Position::outside;
  return all_sides(true) ? Position::inside : Position::rim;
}

/// Over some place that is over no edge there is exactly one facet.
void Polyhedron::find_place(Label i, const std::vector<Placed>& sheet, Report& report) const {
  constexpr int tries = 16;
  const Rational& radius = charts_.patch(i).radius.exact;
  for (int k = 1; k <= tries; ++k) {
    const Quantity x(radius * Rational(k) / Rational(3 * tries)),
        y(radius * Rational(7 * k % tries) / Rational(5 * tries));
    std::size_t inside = 0;
    bool on_rim = false;
    for (const Placed& placed : sheet) {
      const Position found = position(i, placed, x, y);
      inside += found == Position::inside ? 1 : 0;
      on_rim = on_rim || found == Position::rim;
    }
    if (on_rim) continue;
    if (inside != 1) {
      report.reject("sub.graph", [&] {
        return "over a place of the chart of label " + std::to_string(i) + " there are " + std::to_string(inside) +
               " facets";
      });
    }
    return;
  }
  throw Undecided("over which place of the chart of label " + std::to_string(i) + " there is one facet");
}

void Polyhedron::check_graph(Label i, Report& report) {
  const TangentChart<Interval>& chart = charts_.chart(i);
  const TangentPatch& patch = charts_.patch(i);
  std::string fault;
  lid_.push_back(patch.height.filter.lower());
  home_.push_back(0);
  std::vector<Placed> sheet;
  int turn = 0;
  double highest = 0;
  const double reach = upper_root(square(patch.radius.filter) + square(patch.height.filter)) + facet_radius_;
  near_facets_.visit(chart.centre, reach, [&](std::uint32_t facet) {
    Budget::spend(60);
    const Placed placed{facet, placed_in(facet, chart)};
    if (misses_disc(i, placed) || is_beyond_lid(i, placed)) return;
    sheet.push_back(placed);
    for (const auto& corner : placed.filter) highest = std::max({highest, corner[2].upper(), -corner[2].lower()});
    if (!fault.empty()) return;
    const int here = sign(i, placed);
    if (!is_below_lid(i, placed)) {
      fault = facet_name(facet) + " meets the lid";
    } else if (here == 0 || (turn != 0 && here != turn)) {
      fault = facet_name(facet) + " is turned over";
    } else if (!is_flat(i, placed)) {
      fault = facet_name(facet) + " is steeper than stated";
    }
    turn = here;
  });
  if (fault.empty() && sheet.empty()) fault = "there is no facet";
  if (fault.empty() && exact_chart(i).Y[0].sign() == 0) fault = "the preconditioner is 0";
  if (!fault.empty()) {
    report.reject("sub.graph", [&] { return "in the chart of label " + std::to_string(i) + ": " + fault; });
  } else {
    find_place(i, sheet, report);
    if (!(highest < patch.height.filter.lower()))
      throw Undecided("whether the lid of the chart of label " + std::to_string(i) + " is high enough");
    lid_[i] = NearPoints::middle(Interval::between(highest, patch.height.filter.lower()));
  }
  const Quantity x(exact_chart(i).home[0]), y(exact_chart(i).home[1]);
  for (const Placed& placed : sheet) {
    if (position(i, placed, x, y) == Position::outside) continue;
    home_[i] = placed.facet;
    return;
  }
}

Interval Polyhedron::height_over(Label i, const Matrix<Interval>& place, const Interval& guess, double reach) const {
  const TangentChart<Interval>& chart = charts_.chart(i);
  bool found = false;
  Interval result(0);
  Matrix<Interval> up(1, 1);
  up[0] = guess;
  near_facets_.visit(
      chart.centre + chart.tangent * place + chart.normal * up, reach + facet_radius_, [&](std::uint32_t facet) {
        Budget::spend(20);
        const Corners<Interval> a = placed_in(facet, chart);
        const Interval turned = normal_of(a)[2];
        Verdict inside = Verdict::proved, low = Verdict::proved;
        for (std::size_t k = 0; k < 3; ++k) {
          inside = conjunction(inside, less_equal(Interval(0), turned * side_of(a, k, place[0], place[1])));
          low = conjunction(low, conjunction(less(a[k][2], charts_.patch(i).height.filter),
                                             less(-a[k][2], charts_.patch(i).height.filter)));
        }
        if (inside == Verdict::refuted || low == Verdict::refuted) return;
        const Interval height = height_in(a, place[0], place[1]);
        result = found ? joined(result, height) : height;
        found = true;
      });
  const double unknown = std::numeric_limits<double>::infinity();
  return found ? result : Interval::between(-unknown, unknown);
}

/// On conv σ the function is the difference of the heights of σ and of the facets, which is greatest at vertices of
/// facets; and it is a mean of (J_v - J)(x - p_v) for any J.
Polyhedron::Hull Polyhedron::hull(Label i, std::size_t s, double displacement) const {
  const Certificate& c = charts_.certificate();
  const TangentChart<Interval>& chart = charts_.chart(i);
  const Label* labels = c.simplex(s);
  Corners<Interval> simplex{};
  double longest = 0;
  for (std::size_t v = 0; v < 3; ++v) {
    const Matrix<Interval> offset = charts_.point(labels[v]) - chart.centre,
                           along = transposed_times(chart.tangent, offset), up = transposed_times(chart.normal, offset);
    simplex[v] = {along[0], along[1], up[0]};
    longest = std::max(longest, norm_above(charts_.point(labels[v]) - charts_.point(labels[(v + 1) % 3])));
  }
  const Interval area = normal_of(simplex)[2];
  const bool is_left = area.lower() > 0, is_known = is_left || area.upper() < 0;
  const auto is_beside = [&](const Corners<Interval>& a, double distance, std::size_t axis) {
    double least = simplex[0][axis].lower(), greatest = simplex[0][axis].upper();
    for (const auto& corner : simplex) {
      least = std::min(least, corner[axis].lower());
      greatest = std::max(greatest, corner[axis].upper());
    }
    bool is_below = true, is_above = true;
    for (const auto& corner : a) {
      is_below = is_below && (at_double(least) - corner[axis]).lower() > distance;
      is_above = is_above && (corner[axis] - at_double(greatest)).lower() > distance;
    }
    return is_below || is_above;
  };
  const auto may_be_over = [&](const Corners<Interval>& a, double distance) {
    if (is_beside(a, distance, 0) || is_beside(a, distance, 1)) return false;
    for (std::size_t k = 0; is_known && k < 3; ++k) {
      const std::array<Interval, 3>&from = simplex[k], &to = simplex[(k + 1) % 3];
      const double margin = distance * upper_root(square(to[0] - from[0]) + square(to[1] - from[1]));
      bool is_beyond = true;
      for (const auto& corner : a) {
        const Interval side = side_of(simplex, k, corner[0], corner[1]);
        is_beyond = is_beyond && (is_left ? -side : side).lower() > margin;
      }
      if (is_beyond) return false;
    }
    return true;
  };
  Hull result;
  double overlay = 0;
  const double stretch = upper_root(Interval(1) + square(M_.slope.filter));
  near_facets_.visit(charts_.point(labels[0]), stretch * (longest + displacement) + facet_radius_,
                     [&](std::uint32_t facet) {
                       Budget::spend(40);
                       const Corners<Interval> a = placed_in(facet, chart);
                       Verdict beyond = Verdict::proved;
                       for (const auto& corner : a) {
                         beyond = conjunction(beyond, disjunction(less(charts_.patch(i).height.filter, corner[2]),
                                                                  less(charts_.patch(i).height.filter, -corner[2])));
                       }
                       if (beyond == Verdict::proved || !may_be_over(a, displacement)) return;
                       const std::array<Interval, 3> normal = normal_of(a);
                       Matrix<Interval> slope(1, 3);
                       for (std::size_t axis = 0; axis < 3; ++axis) {
                         slope[axis] = (chart.tangent(axis, 0) * (normal[0] / normal[2]) +
                                        chart.tangent(axis, 1) * (normal[1] / normal[2]) + chart.normal(axis, 0)) /
                                       chart.Y[0];
                       }
                       result.slopes.push_back(std::move(slope));
                       if (!may_be_over(a, 0)) return;
                       for (const auto& corner : a) {
                         Interval flat(0);
                         for (std::size_t k = 0; k < 3; ++k)
                           flat = flat + side_of(simplex, k, corner[0], corner[1]) / area * simplex[(k + 2) % 3][2];
                         const Interval above = (corner[2] - flat) / chart.Y[0];
                         overlay = std::max({overlay, above.upper(), -above.lower()});
                       }
                     });
  const double unknown = std::numeric_limits<double>::infinity();
  if (result.slopes.empty()) {
    result.slopes.emplace_back(1, 3);
    result.height = unknown;
    return result;
  }
  Matrix<Interval> middle = result.slopes[0];
  for (const Matrix<Interval>& slope : result.slopes) {
    for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = joined(middle[axis], slope[axis]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] = at_double(NearPoints::middle(middle[axis]));
  double radius = 0;
  for (const Matrix<Interval>& slope : result.slopes) radius = std::max(radius, norm_above(slope - middle));
  const double by_slopes = radius * upper_root(square(at_double(longest)) / Interval(3));
  result.height = std::min(is_known ? overlay : unknown, by_slopes);
  return result;
}

/// With A symmetric, s + A y has the slope <e, A e> along a unit vector e, and slopes of facets differ from it most at
/// a corner. Least squares choose s and A.
Polyhedron::Change Polyhedron::slope_change(Label i, const Matrix<Interval>& point, double wide) const {
  const TangentChart<Interval>& chart = charts_.chart(i);
  const Matrix<Interval> home = transposed_times(chart.tangent, point - chart.centre);
  struct Sloped {
    Corners<Interval> corners;
    Interval slope[2];
  };
  std::vector<Sloped> facets;
  bool vertical = false;
  const double stretch = upper_root(Interval(1) + square(M_.slope.filter));
  near_facets_.visit(point, stretch * wide + facet_radius_, [&](std::uint32_t facet) {
    Budget::spend(40);
    const Corners<Interval> a = placed_in(facet, chart);
    const Interval& lid = charts_.patch(i).height.filter;
    bool above = true, below = true;
    for (const auto& corner : a) {
      above = above && less(lid, corner[2]) == Verdict::proved;
      below = below && less(lid, -corner[2]) == Verdict::proved;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      bool left = true, right = true;
      for (const auto& corner : a) {
        left = left && (home[k] - corner[k]).lower() > wide;
        right = right && (corner[k] - home[k]).lower() > wide;
      }
      if (left || right) return;
    }
    if (above || below) return;
    const std::array<Interval, 3> normal = normal_of(a);
    vertical = vertical || !(normal[2].lower() > 0 || normal[2].upper() < 0);
    facets.push_back({a, {-(normal[0] / normal[2]), -(normal[1] / normal[2])}});
  });
  const double unknown = std::numeric_limits<double>::infinity();
  if (vertical || facets.empty()) return {unknown, unknown};
  Matrix<Interval> squares(5, 5), products(5, 1);
  for (const Sloped& facet : facets) {
    Interval middle[2] = {Interval(0), Interval(0)};
    for (const auto& corner : facet.corners) {
      for (std::size_t k = 0; k < 2; ++k) middle[k] = middle[k] + corner[k] / Interval(3);
    }
    for (std::size_t k = 0; k < 2; ++k) {
      Matrix<Interval> row(5, 1);  // of s_0, s_1, A_00, A_01, A_11
      row[k] = Interval(1);
      row[2 + k] = middle[0];
      row[3 + k] = middle[1];
      squares = squares + row * row.transposed();
      products = products + facet.slope[k] * row;
    }
  }
  Matrix<Interval> affine = solution(squares, products);
  for (std::size_t k = 0; k < 5; ++k) {
    const double middle = NearPoints::middle(affine[k]);
    affine[k] = at_double(middle > -0x1p100 && middle < 0x1p100 ? middle : 0);
  }
  Change result;
  for (const Sloped& facet : facets) {
    for (const auto& corner : facet.corners) {
      Interval squared(0);
      for (std::size_t k = 0; k < 2; ++k)
        squared = squared + square(facet.slope[k] - affine[k] - affine[2 + k] * corner[0] - affine[3 + k] * corner[1]);
      result.size = std::max(result.size, upper_root(squared));
    }
  }
  const Interval half = Interval(1) / Interval(2), sum = half * (affine[2] + affine[4]);
  result.rate = maximum(sum, -sum).upper() + upper_root(square(half * (affine[2] - affine[4])) + square(affine[3]));
  return result;
}

/// Whether the point is certainly in the cylinder. `all` stays refuted if it certainly is not.
bool Polyhedron::is_in(Label i, const Matrix<Interval>& x, Verdict& all) const {
  const Matrix<Interval> offset = x - charts_.chart(i).centre;
  const Interval up = transposed_times(charts_.chart(i).normal, offset)[0];
  const Interval& lid = charts_.patch(i).height.filter;
  const Verdict result = conjunction(
      less(squared_norm(transposed_times(charts_.chart(i).tangent, offset)), square(charts_.patch(i).radius.filter)),
      conjunction(less(up, lid), less(-up, lid)));
  all = disjunction(all, result);
  return result == Verdict::proved;
}

/// A part of a facet with its vertices in a cylinder, which is convex, is in it.
std::size_t Polyhedron::check_cover(Report& report) const {
  double reach = 0;
  for (Label i = 0; i < charts_.certificate().n; ++i) {
    const TangentPatch& patch = charts_.patch(i);
    reach = std::max(reach, upper_root(square(patch.radius.filter) + square(patch.height.filter)));
  }
  using Part = std::array<Matrix<Interval>, 3>;
  std::size_t parts = 0;
  for (std::size_t f = 0; f < M_.facets.size(); ++f) {
    std::vector<Part> open{{vertices_[M_.facets[f][0]], vertices_[M_.facets[f][1]], vertices_[M_.facets[f][2]]}};
    for (std::size_t looked_at = 0; !open.empty(); ++looked_at, ++parts) {
      const Part part = std::move(open.back());
      open.pop_back();
      const Matrix<Interval> middle = (Interval(1) / Interval(3)) * (part[0] + part[1] + part[2]);
      bool covered = false;
      Verdict met = Verdict::refuted, ignored = Verdict::refuted;
      for (const double distance : {reach / 4, reach}) {
        if (covered) break;
        charts_.centres().visit(middle, distance, [&](Label i) {
          if (covered) return;
          Budget::spend(10);
          covered = is_in(i, middle, met) && is_in(i, part[0], ignored) && is_in(i, part[1], ignored) &&
                    is_in(i, part[2], ignored);
        });
      }
      if (covered) continue;
      if (met == Verdict::refuted) {
        report.reject("sub.cover", [&] { return facet_name(f) + " has a point that no chart shows"; });
        return parts;
      }
      if (looked_at == most_parts_of_facet) throw Undecided("whether all of " + facet_name(f) + " is shown by charts");
      std::size_t longest = 0;
      double most = -1;
      for (std::size_t k = 0; k < 3; ++k) {
        const double length = norm_above(part[(k + 1) % 3] - part[k]);
        if (length > most) {
          most = length;
          longest = k;
        }
      }
      const std::size_t next = (longest + 1) % 3;
      const Matrix<Interval> half = (Interval(1) / Interval(2)) * (part[longest] + part[next]);
      open.push_back(part);
      open.back()[next] = half;
      open.push_back(part);
      open.back()[longest] = half;
    }
  }
  return parts;
}

}  // namespace delcert::checker
