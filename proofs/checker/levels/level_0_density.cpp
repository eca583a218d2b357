#include <algorithm>
#include <cmath>

#include "proofs/checker/core/frame.hpp"
#include "proofs/checker/geometry/simplex.hpp"
#include "proofs/checker/levels/levels.hpp"
#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker {
namespace {

std::size_t net_simplex_count(const Certificate& c) {
  return c.net_simplices.size() / (static_cast<std::size_t>(c.m) + 1);
}

/// The lift of the label at distance < 2 epsilon from the first vertex: there is at most one, by 0.patch. Where it
/// should be, a guess is enough.
bool find_lift(const Certificate& c, const Vertex& first, Label label, const Quantity& reach, Lift& lift) {
  const Vector<Interval> offset = c.net.position<Interval>(first) - c.net.position<Interval>({label, {}});
  for (std::size_t k = 0; c.torus && k < c.m_size(); ++k) {
    const double x = offset[k].upper() + 0.5;
    if (!(std::fabs(x) < 0x1p30)) break;
    lift[k] = static_cast<std::int32_t>(x) - (x < 0 ? 1 : 0);
  }
  const Interval squared = c.net.between<Interval>(first, {label, lift});
  if (is_decided(less(squared, square(reach.filter)) == Verdict::proved)) return true;
  const std::vector<Lift> found = c.net.lifts_within(first, label, reach, false);
  if (found.size() == 1) lift = found[0];
  return found.size() == 1;
}

/// Calls f for the labels and the vertices of net simplices number begin ... end - 1: the first vertex as it stands,
/// the others at their only lifts at distance < 2 epsilon; nothing instead of the vertices if these do not exist.
template <class F>
void for_net_simplices(const Certificate& c, std::size_t begin, std::size_t end, const F& f) {
  const Quantity reach(Rational(2) * c.epsilon.exact);
  const auto size = static_cast<std::size_t>(c.m) + 1;
  Vertices vertices(size);
  for (std::size_t s = begin; s < end; ++s) {
    const Label* labels = &c.net_simplices[s * size];
    bool is_known = true;
    for (std::size_t k = 0; k < size && is_known; ++k) {
      vertices[k] = {labels[k], {}};
      is_known = k == 0 || find_lift(c, vertices[0], labels[k], reach, vertices[k].lift);
    }
    f(labels, is_known ? &vertices : nullptr);
  }
}

template <class F>
void for_each_net_simplex(const Certificate& c, const F& f) {
  for_net_simplices(c, 0, net_simplex_count(c), f);
}

/// All vertices are at distance < radius from the circumcentre of the face; refuted if the face is degenerate.
template <class N>
Verdict in_ball_about(const Certificate& c, const Vertices& vertices, const Vertices& face, const Quantity& radius) {
  const std::vector<Vector<N>> corners = c.net.positions<N>(face);
  const Simplex<N> simplex(c.metric, corners);
  if (simplex.complete != Verdict::proved) return simplex.complete;
  Verdict result = less(simplex.radius_squared, square(radius.as<N>()));  // those of the face
  for (const Vertex& v : vertices) {
    if (result != Verdict::proved || std::find(face.begin(), face.end(), v) != face.end()) continue;
    const Vector<N> x = c.net.position<N>(v) - corners[0];
    result = less(simplex.power(x) + simplex.radius_squared, square(radius.as<N>()));
  }
  return result;
}

/// The vertices as seen from the first one, the columns from the second one on.
template <class N>
core::Columns<N> edges(const Certificate& c, const Vertices& vertices) {
  const Vector<N> first = c.net.position<N>(vertices[0]);
  core::Columns<N> result{};
  for (std::size_t k = 1; k < vertices.size(); ++k) result[k - 1] = c.net.position<N>(vertices[k]) - first;
  return result;
}

/// All vertices are at distance < radius from a point that is nearly the circumcentre, by doubles: any point would do.
bool is_in_ball_about_middle(const Certificate& c, const Vertices& vertices, const Quantity& radius) {
  const std::size_t m = c.m_size();
  const core::Columns<Interval> edge = edges<Interval>(c, vertices);
  core::Columns<double> columns{};
  std::array<double, 4> half_square{};
  for (std::size_t k = 0; k < m; ++k) {
    const Vector<Interval> covector = c.metric.covector(edge[k]);
    for (std::size_t i = 0; i < m; ++i) columns[k][i] = covector[i].upper();
    half_square[k] = dot(edge[k], covector, m).upper() / 2;
  }
  Vector<double> sum{};
  for (std::size_t k = 0; k < m; ++k) sum = add(sum, half_square[k], core::cofactors(columns, m, k));
  const double determinant = dot(core::cofactors(columns, m, 0), columns[0], m);
  Vector<Interval> centre{};
  for (std::size_t i = 0; i < m; ++i) {
    const double x = sum[i] / determinant;
    if (!(std::fabs(x) < 0x1p500)) return false;
    centre[i] = Interval::between(x, x);
  }
  const Interval bound = square(radius.filter);
  Verdict result = less(c.metric.squared_length(centre), bound);
  for (std::size_t k = 0; k < m; ++k)
    result = conjunction(result, less(c.metric.squared_length(edge[k] - centre), bound));
  return result == Verdict::proved;
}

/// For some face, the simplex itself first.
bool is_in_open_ball(const Certificate& c, const Vertices& vertices, const Quantity& radius) {
  if (is_decided(is_in_ball_about_middle(c, vertices, radius))) return true;
  for (unsigned subset = (1u << vertices.size()) - 1; subset > 0; --subset) {
    Vertices face;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      if ((subset >> k & 1) != 0) face.push_back(vertices[k]);
    }
    if (decide([&]<class N>(In<N>) { return in_ball_about<N>(c, vertices, face, radius); })) return true;
  }
  return false;
}

/// Of the edge vectors from the first vertex, in the order of the vertices, in frame coordinates.
template <class N>
N determinant(const Certificate& c, const Vertices& vertices) {
  const core::Columns<N> columns = edges<N>(c, vertices);
  return dot(core::cofactors(columns, c.m_size(), 0), columns[0], c.m_size());
}

template <class N>
N sum_of_determinants(const Certificate& c) {
  N sum(0);
  for_each_net_simplex(c, [&](const Label*, const Vertices* vertices) {
    if (vertices) sum = sum + determinant<N>(c, *vertices);
  });
  return sum;
}

/// The sum is m!. By 0.cycle it is a multiple of m!, so that an enclosure of m! narrower than m! decides.
Verdict is_factorial(const Interval& sum, int factorial) {
  if (factorial < sum.lower() || sum.upper() < factorial) return Verdict::refuted;
  return sum.lower() > 0 && sum.upper() < 2 * factorial ? Verdict::proved : Verdict::undecided;
}
Verdict is_factorial(const Rational& sum, int factorial) { return verdict(sum == Rational(factorial)); }

void check_degree_on_torus(const Certificate& c, Report& report) {
  constexpr std::array<int, 5> factorials = {1, 1, 2, 6, 24};
  const int factorial = factorials[static_cast<std::size_t>(c.m)];
  if (decide([&]<class N>(In<N>) { return is_factorial(sum_of_determinants<N>(c), factorial); })) return;
  report.reject("0.degree", [&] {
    return "the determinants of the net simplices add up to about " + about(sum_of_determinants<Interval>(c)) +
           ", not to " + std::to_string(factorial);
  });
}

void check_degree_on_ball(const Certificate& c, Report& report) {
  bool inside = false;
  for_each_net_simplex(c, [&](const Label* labels, const Vertices* vertices) {
    if (!vertices) return;
    const auto negative = [&]<class N>(In<N>) { return less(determinant<N>(c, *vertices), N(0)); };
    const auto positive = [&]<class N>(In<N>) { return less(N(0), determinant<N>(c, *vertices)); };
    if (decide(negative)) {
      report.reject("0.degree",
                    [&] { return "net simplex " + label_set(labels, labels + c.m + 1) + " has negative determinant"; });
    }
    for (std::size_t k = 0; k < vertices->size() && !inside; ++k) {
      const auto near = [&]<class N>(In<N>) {
        return less(c.metric.squared_length(c.net.position<N>((*vertices)[k])), square(c.radius.as<N>()));
      };
      inside = decide(near) && decide(positive);
    }
  });
  if (!inside) report.reject("0.degree", [] { return "no net simplex of positive determinant reaches into the ball"; });
}

}  // namespace

void check_balls(const Certificate& c, Report& report) {
  const Quantity greatest(c.epsilon.exact / c.radius_factor().exact);
  const auto check = [&](const Label* labels, const Vertices* vertices, Report& found) {
    Quantity memory;
    if (vertices && is_in_open_ball(c, *vertices, c.at_least(labels, labels + c.m + 1, greatest, memory))) return;
    found.reject("0.ball", [&] {
      return "net simplex " + label_set(labels, labels + c.m + 1) +
             (vertices ? " is in no open ball of the radius of its vertices"
                       : " has a vertex with no lift or several within 2 epsilon");
    });
  };
  in_parts("0.ball", net_simplex_count(c), report, [&](std::size_t begin, std::size_t end, Report& found) {
    for_net_simplices(c, begin, end,
                      [&](const Label* labels, const Vertices* vertices) { check(labels, vertices, found); });
    return Counts{};
  });
}

void check_degree(const Certificate& c, Report& report) {
  if (c.torus) {
    check_degree_on_torus(c, report);
  } else {
    check_degree_on_ball(c, report);
  }
}

}  // namespace delcert::checker
