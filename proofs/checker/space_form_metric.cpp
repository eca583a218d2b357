#include <algorithm>
#include <map>

#include "proofs/checker/run.hpp"
#include "proofs/checker/space_form_levels.hpp"

namespace delcert::checker {
namespace {

/// The lift in the chart of the perturbed point v, from conformal coordinates about the original one.
template <class N>
Vector<N> about_perturbed(const Certificate& c, const Vector<N>& v, const Vector<N>& a) {
  const int K = c.space_form->K;
  const Vector<N> moved = conformal(c.m_size(), seen_from(K, c.m_size(), v, linear(K, c.m_size(), a)));
  return add(Vector<N>{}, logarithm_factor(K, squared(moved, c.m_size()) / N(4)), moved);
}

void check_riemannian_simplices(const Certificate& c, const Lifts& lifts, Report& report) {
  const Rational& h = c.riemannian_radius.exact;
  const Rational& inj = c.space_form->injectivity_radius.exact;
  if (less(inj, Rational(4) * h) == Verdict::proved ||
      (c.space_form->K != 0 && less(c.riemannian_thickness.exact, Rational(6) * h) == Verdict::proved)) {
    report.reject("5.radius", [] { return "radius is more than injectivity radius / 4 or thickness / 6"; });
  }
  for (Label i = 0; i < c.n; ++i) {
    const Chart chart(c, lifts, i, c.reach_4(), Coordinates::conformal);
    for (std::size_t s = 0; s < c.star_size(i); ++s) {
      const Label* others = c.star_simplex(i, s);
      Label missing = 0;
      const std::vector<std::size_t> vertices = chart.find(i, others, missing);
      if (vertices.empty()) continue;  // 4.lifts
      const auto positions = [&]<class N>(In<N>) {
        const Vector<N> v = chart.conformal<N>(vertices[0]);
        std::vector<Vector<N>> result{Vector<N>{}};
        for (std::size_t k = 1; k < vertices.size(); ++k)
          result.push_back(about_perturbed(c, v, chart.conformal<N>(vertices[k])));
        return result;
      };
      const bool thick = decide_enclosed(
          [&]<class N>(In<N> in) { return is_thick(c.metric, positions(in), square(c.riemannian_thickness.as<N>())); });
      if (!thick) {
        report.reject("5.thickness", [&] {
          return simplex_of_star(c, i, others) + " is thinner than " + rounded_up(c.riemannian_thickness.exact);
        });
      }
      const bool near = decide_enclosed([&]<class N>(In<N> in) {
        Verdict result = Verdict::proved;
        for (const Vector<N>& x : positions(in))
          result = conjunction(result, less(squared(x, c.m_size()), square(c.riemannian_radius.as<N>())));
        return result;
      });
      if (!near) report.reject("5.radius", [&] { return simplex_of_star(c, i, others) + " is larger than radius"; });
    }
  }
}

/// cot alpha + cot beta > weight for the angles opposite to an edge, from the squared lengths: with s = a^2 + b^2 - e^2
/// and q = 4 a^2 b^2 - s^2, cot alpha = s / sqrt q.
template <class N>
Verdict is_locally_delaunay(const Certificate& c, const Chart& chart, std::size_t i, std::size_t j,
                            const std::array<std::size_t, 2>& apexes) {
  const auto length = [&](std::size_t x, std::size_t y) {
    return squared_distance(c.space_form->K, 2, chart.conformal<N>(x), chart.conformal<N>(y));
  };
  const N edge = length(i, j);
  N sum(0);
  for (const std::size_t apex : apexes) {
    const N a = length(i, apex), b = length(j, apex), s = a + b - edge;
    sum = sum + s / square_root(N(4) * a * b - square(s));
  }
  return less(c.weight.as<N>(), sum);
}

void check_self_delaunay(const Certificate& c, const Lifts& lifts, Report& report) {
  for (Label i = 0; i < c.n; ++i) {
    const Chart chart(c, lifts, i, c.reach_4(), Coordinates::conformal);
    std::map<Label, std::vector<Label>> across;  // the third labels of the triangles at the edge {i, j}
    for (std::size_t s = 0; s < c.star_size(i); ++s) {
      const Label* others = c.star_simplex(i, s);
      across[others[0]].push_back(others[1]);
      across[others[1]].push_back(others[0]);
    }
    for (const auto& [j, thirds] : across) {
      if (j < i || thirds.size() != 2) continue;  // 1.facets
      const std::array<std::size_t, 2> apexes{chart.find(thirds[0]), chart.find(thirds[1])};
      const std::size_t at_i = chart.find(i), at_j = chart.find(j);
      if (std::max({apexes[0], apexes[1], at_i, at_j}) == Chart::none) continue;  // 4.lifts
      const bool fine =
          decide_enclosed([&]<class N>(In<N>) { return is_locally_delaunay<N>(c, chart, at_i, at_j, apexes); });
      if (fine) continue;
      report.reject("6.self-delaunay", [&, end = j] {
        return "the cotangents of the angles opposite to the edge {" + std::to_string(i) + ", " + std::to_string(end) +
               "} have a sum of at most weight";
      });
    }
  }
}

/// With k = cos^2 rho = 1/(1 + K tan^2 rho): B^2 k G_D - G_C and G_C - (A^2 / k) G_D are positive definite. (For K < 0,
/// a >= A cosh rho and b <= B / cosh rho in the same form.)
template <class N>
Verdict is_stretched_within(const Certificate& c, const Chart& chart, const ChartSimplex& simplex,
                            const Simplex<N>& s) {
  const int K = c.space_form->K;
  const N &least = c.least_stretch.as<N>(), &greatest = c.greatest_stretch.as<N>();
  if (K == 0) return conjunction(less_equal(least, N(1)), less_equal(N(1), greatest));  // an isometry
  const std::size_t m = c.m_size();
  const std::vector<std::size_t>& vertices = simplex.vertices();
  const ConformalBall<N> ball(c, s, chart.position<N>(vertices[0]));
  const N bent = ball.radius_squared / square(ball.weight);
  const N k = K > 0 ? N(1) / (N(1) + bent) : N(1) - bent;
  const auto gram = [&](const auto& squared_length) {
    SquareMatrix<N> result(m);
    for (std::size_t x = 0; x < m; ++x) {
      for (std::size_t y = 0; y < m; ++y) {
        const auto length = [&](std::size_t v, std::size_t w) {
          return v == w ? N(0) : squared_length(K, m, chart.conformal<N>(vertices[v]), chart.conformal<N>(vertices[w]));
        };
        result(x, y) = (length(0, x + 1) + length(0, y + 1) - length(x + 1, y + 1)) / N(2);
      }
    }
    return result;
  };
  const SquareMatrix<N> flat = gram(squared_distance<N>), straight = gram(squared_chord<N>);
  SquareMatrix<N> above(m), below(m);
  for (std::size_t x = 0; x < m; ++x) {
    for (std::size_t y = 0; y < m; ++y) {
      above(x, y) = square(greatest) * k * flat(x, y) - straight(x, y);
      below(x, y) = straight(x, y) - square(least) / k * flat(x, y);
    }
  }
  return conjunction(is_positive_definite(above), is_positive_definite(below));
}

}  // namespace

std::string check_triangulation_of_space_form(const Certificate& c, const Lifts& lifts, Report& report) {
  if (!c.riemannian_simplices) return "follows from level 4";
  check_riemannian_simplices(c, lifts, report);
  return "follows from level 4; and from Riemannian simplices of thickness >= " +
         rounded_down(c.riemannian_thickness.exact) + " within " + rounded_up(c.riemannian_radius.exact);
}

std::string check_metric_of_space_form(const Certificate& c, const Lifts& lifts, Report& report) {
  if (c.self_delaunay) check_self_delaunay(c, lifts, report);
  for_each_simplex(c, lifts, [&](const Chart& chart, const ChartSimplex& simplex, Label i, const Label* others) {
    if (simplex.decide([&]<class N>(const Simplex<N>& s) { return is_stretched_within<N>(c, chart, simplex, s); }))
      return;
    report.reject("6.bilipschitz",
                  [&] { return simplex_of_star(c, i, others) + " is stretched beyond the bounds of bilipschitz"; });
  });
  return std::string(c.self_delaunay ? "self-Delaunay, " : "") + "distances stretched by " +
         rounded_down(c.least_stretch.exact) + " to " + rounded_up(c.greatest_stretch.exact);
}

}  // namespace delcert::checker
