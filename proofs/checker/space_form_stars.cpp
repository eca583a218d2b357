#include <algorithm>
#include <limits>
#include <set>

#include "proofs/checker/run.hpp"
#include "proofs/checker/space_form_levels.hpp"

namespace delcert::checker {

bool is_shown_by_charts(const Certificate& c, const Rational& reach) {
  return less(reach, Rational(9) * c.epsilon.exact) == Verdict::proved &&
         less(reach, c.space_form->injectivity_radius.exact) == Verdict::proved;
}

std::string simplex_of_star(const Certificate& c, Label i, const Label* others) {
  return "simplex " + label_set(others, others + c.m) + " in the star of " + std::to_string(i);
}

namespace {

/// All points that the chart shows are farther than `margin` outside of the circumscribing sphere.
void check_protection(const Chart& chart, const ChartSimplex& simplex, const Quantity& margin, Report& report,
                      const char* rule, const std::string& which) {
  const std::size_t first = simplex.vertices()[0];
  // Farther from the origin than |C| + R + margin there is nothing to decide.
  double reach = std::numeric_limits<double>::infinity();
  const Simplex<Interval>& filter = simplex.filter();
  if (filter.complete == Verdict::proved) {
    const Vector<Interval> centre = add(chart.position<Interval>(first), Interval(1), filter.centre);
    const double length = upper_root(squared(centre, filter.dimension())), radius = upper_root(filter.radius_squared);
    reach = (Interval::between(0, length) + Interval::between(0, radius) + margin.filter).upper();
  }
  for (std::size_t q = 0; q < chart.size(); ++q) {
    if (chart.distance(q) > reach || simplex.is_vertex(q)) continue;
    const bool clear = simplex.decide([&]<class N>(const Simplex<N>& s) {
      return is_clear<N>(s, chart.position<N>(q) - chart.position<N>(first), margin.as<N>());
    });
    if (clear) continue;
    report.reject(rule, [&] {
      return which + " has label " + std::to_string(chart.label(q)) + " within circumradius + " +
             rounded_up(margin.exact) + " of its circumcentre";
    });
  }
}

/// |C| + R <= a.
template <class N>
Verdict is_ball_within(const N& centre_squared, const N& radius_squared, const N& a) {
  const N rest = square(a) - centre_squared - radius_squared;
  return conjunction(less_equal(N(0), rest), less_equal(N(4) * centre_squared * radius_squared, square(rest)));
}

/// Flat charts are isometric, so that one of them speaks for all: that of the smallest label.
bool is_looked_at_elsewhere(const Certificate& c, Label i, const Label* others) {
  return c.space_form->K == 0 && std::any_of(others, others + c.m, [&](Label k) { return k < i; });
}

void check_star(const Certificate& c, const Chart& chart, Label i, Report& report) {
  for (std::size_t s = 0; s < c.star_size(i); ++s) {
    const Label* others = c.star_simplex(i, s);
    if (is_looked_at_elsewhere(c, i, others)) continue;
    const std::string which = simplex_of_star(c, i, others);
    Label missing = 0;
    std::vector<std::size_t> vertices = chart.find(i, others, missing);
    if (vertices.empty()) {
      report.reject("1.vertices", [&] { return which + ": its chart does not show " + std::to_string(missing); });
      continue;
    }
    const ChartSimplex simplex(c, chart, std::move(vertices));
    const bool small = simplex.decide(
        [&]<class N>(const Simplex<N>& t) { return less_equal(t.radius_squared, square(c.circumradius.as<N>())); });
    if (!small) {
      report.reject("1.radius", [&] {
        return which + " has a squared circumradius of about " + about(simplex.filter().radius_squared);
      });
    }
    const bool thick = simplex.decide([&]<class N>(const Simplex<N>&) {
      return is_thick(c.metric, chart.positions<N>(simplex.vertices()), square(c.thickness.as<N>()));
    });
    if (!thick)
      report.reject("1.thickness", [&] { return which + " is thinner than " + rounded_up(c.thickness.exact); });
    check_protection(chart, simplex, c.protection, report, "1.protection", which);
  }
}

}  // namespace

std::string check_stars_in_charts(const Certificate& c, const Lifts& lifts, Report& report) {
  if (!is_shown_by_charts(c, c.reach_1())) {
    report.reject("1.patch", [&] {
      return "perturbation + 2 circumradius + protection is not below 9 epsilon and the injectivity radius";
    });
  }
  std::size_t simplices = 0;
  for (Label i = 0; i < c.n; ++i) {
    const bool near = decide_enclosed([&]<class N>(In<N>) {
      return less_equal(squared(lifts.vector_of<N>(i), c.m_size()), square(c.rho.as<N>() * c.epsilon.as<N>()));
    });
    if (!near) {
      report.reject("1.perturbation",
                    [&] { return "label " + std::to_string(i) + " is moved by more than perturbation epsilon"; });
    }
    check_star(c, Chart(c, lifts, i, c.reach_1()), i, report);
    for (std::size_t s = 0; s < c.star_size(i); ++s)
      if (!is_looked_at_elsewhere(c, i, c.star_simplex(i, s))) ++simplices;
  }
  return std::to_string(simplices) +
         " simplices in the charts of their vertices, protection >= " + rounded_down(c.protection.exact) +
         ", thickness >= " + rounded_down(c.thickness.exact) + ", circumradius <= " + rounded_up(c.circumradius.exact);
}

/// In the chart of j, the stars of j and of all labels of star(j). j is in the stars of just these.
std::string check_stable_stars_in_charts(const Certificate& c, const Lifts& lifts, Report& report) {
  if (!is_shown_by_charts(c, c.reach_2s.exact))
    report.reject("2s.patch", [] { return "reach is not below 9 epsilon and the injectivity radius"; });
  // By level 1, where the charts are isometric and see all of it (docs/levels/space-forms.md).
  const Rational enough = Rational(4) * c.circumradius.exact + c.rho.exact * c.epsilon.exact;
  if (c.space_form->K == 0 && less_equal(enough, c.reach_2s.exact) == Verdict::proved)
    return "every chart of a star sees the same star, as it is isometric and shows 4 circumradii";
  const Quantity none(Rational(0));
  for (Label j = 0; j < c.n; ++j) {
    std::set<Label> centres;
    for (std::size_t s = 0; s < c.star_size(j); ++s) centres.insert(c.star_simplex(j, s), c.star_simplex(j, s) + c.m);
    const Chart chart(c, lifts, j, c.reach_2s.exact);
    for (const Label i : centres) {
      for (std::size_t s = 0; s < c.star_size(i); ++s) {
        const Label* others = c.star_simplex(i, s);
        // Once for each simplex: at its smallest label among the centres.
        if (std::any_of(others, others + c.m, [&](Label k) { return k < i && centres.contains(k); })) continue;
        const std::string which = simplex_of_star(c, i, others) + ", in the chart of " + std::to_string(j) + ",";
        Label missing = 0;
        std::vector<std::size_t> vertices = chart.find(i, others, missing);
        if (vertices.empty()) {
          report.reject("2s.reach", [&] { return which + " has no label " + std::to_string(missing); });
          continue;
        }
        const ChartSimplex simplex(c, chart, std::move(vertices));
        const bool within = simplex.decide([&]<class N>(const Simplex<N>& t) {
          const Vector<N> centre = add(chart.position<N>(simplex.vertices()[0]), N(1), t.centre);
          return is_ball_within(squared(centre, c.m_size()), t.radius_squared, c.reach_2s.as<N>());
        });
        if (!within) report.reject("2s.reach", [&] { return which + " has a ball beyond reach"; });
        check_protection(chart, simplex, none, report, "2s.protection", which);
      }
    }
  }
  return "every chart of a star sees the same star";
}

}  // namespace delcert::checker
