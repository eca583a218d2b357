#include <algorithm>
#include <limits>
#include <set>

#include "proofs/checker/metric_field.hpp"
#include "proofs/checker/metric_field_levels.hpp"
#include "proofs/checker/run.hpp"

namespace delcert::checker {
namespace {

std::string star_text(const Certificate& c, Label i, const Label* others) {
  return "simplex " + label_set(others, others + c.m) + " in the star of " + std::to_string(i);
}

/// A simplex of an affine chart with its circumcentre.
class AffineSimplex {
 public:
  AffineSimplex(const Certificate& c, const AffineChart& chart, std::vector<std::size_t> vertices)
      : c_(c), chart_(chart), vertices_(std::move(vertices)), filter_(c.metric, chart.positions<Interval>(vertices_)) {
    if (filter_.complete == Verdict::proved) return;
    const Simplex<Rational> known = exact();
    degenerate_ = known.complete != Verdict::proved;
    if (!degenerate_) filter_ = Simplex<Interval>(known);
  }

  bool is_degenerate() const { return degenerate_; }
  const std::vector<std::size_t>& vertices() const { return vertices_; }
  const Simplex<Interval>& filter() const { return filter_; }
  bool is_vertex(std::size_t at) const { return std::find(vertices_.begin(), vertices_.end(), at) != vertices_.end(); }

  /// The predicate takes a Simplex<N> and returns a Verdict. Precondition: not degenerate.
  template <class Predicate>
  bool holds(const Predicate& predicate) const {
    return decide([&]<class N>(In<N>) {
      if constexpr (std::is_same_v<N, Interval>) {
        return predicate(filter_);
      } else {
        return predicate(exact());
      }
    });
  }

 private:
  Simplex<Rational> exact() const { return Simplex<Rational>(c_.metric, chart_.positions<Rational>(vertices_)); }

  const Certificate& c_;
  const AffineChart& chart_;
  std::vector<std::size_t> vertices_;
  Simplex<Interval> filter_;
  bool degenerate_ = false;
};

/// All points that the chart shows are farther than `margin` outside of the circumscribing sphere.
void check_protection(const AffineChart& chart, const AffineSimplex& simplex, const Quantity& margin, Report& report,
                      const char* rule, const std::string& which) {
  const std::size_t first = simplex.vertices()[0];
  // Farther from the origin than |C| + R + margin there is nothing to decide.
  const std::size_t m = simplex.filter().dimension();
  const Vector<Interval> centre = add(chart.position<Interval>(first), Interval(1), simplex.filter().centre);
  const double length = upper_root(dot(centre, centre, m)), radius = upper_root(simplex.filter().radius_squared);
  const double reach = (Interval::between(0, length) + Interval::between(0, radius) + margin.filter).upper();
  for (std::size_t q = 0; q < chart.size(); ++q) {
    if (chart.distance(q) > reach || simplex.is_vertex(q)) continue;
    const bool clear = simplex.holds([&]<class N>(const Simplex<N>& s) {
      return is_clear<N>(s, chart.position<N>(q) - chart.position<N>(first), margin.as<N>());
    });
    if (clear) continue;
    report.reject(rule, [&] {
      return which + " has label " + std::to_string(chart.vertex(q).label) + " within circumradius + " +
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

void check_star(const Certificate& c, const AffineChart& chart, Label i, Report& report) {
  for (std::size_t s = 0; s < c.star_size(i); ++s) {
    const Label* others = c.star_simplex(i, s);
    const std::string which = star_text(c, i, others);
    std::string reason;
    std::vector<std::size_t> vertices = chart.find(i, others, reason);
    if (vertices.empty()) {
      report.reject("1.vertices", [&] { return which + ": " + reason; });
      continue;
    }
    const AffineSimplex simplex(c, chart, std::move(vertices));
    if (simplex.is_degenerate()) {
      report.reject("1.vertices", [&] { return which + " is degenerate"; });
      continue;
    }
    const bool small = simplex.holds(
        [&]<class N>(const Simplex<N>& t) { return less_equal(t.radius_squared, square(c.circumradius.as<N>())); });
    if (!small) {
      report.reject("1.radius", [&] {
        return which + " has a squared circumradius of about " + about(simplex.filter().radius_squared);
      });
    }
    const bool thick = decide([&]<class N>(In<N>) {
      return is_thick(c.metric, chart.positions<N>(simplex.vertices()), square(c.thickness.as<N>()));
    });
    if (!thick)
      report.reject("1.thickness", [&] { return which + " is thinner than " + rounded_up(c.thickness.exact); });
    check_protection(chart, simplex, c.protection, report, "1.protection", which);
  }
}

bool is_in_patches(const Certificate& c, const Rational& reach) {
  return less(reach, c.metric_field->patch_radius.exact) == Verdict::proved;
}

}  // namespace

std::string check_stars_of_metric_field(const AffineCharts& charts, Report& report) {
  const Certificate& c = charts.certificate();
  const Quantity reach(c.reach_1());
  if (!is_in_patches(c, reach.exact + c.rho.exact * c.epsilon.exact)) {
    report.reject("1.patch", [] { return "2 perturbation + 2 circumradius + protection is not below patch_radius"; });
    return "";
  }
  std::size_t simplices = 0;
  for (Label i = 0; i < c.n; ++i) {
    const bool near = decide([&]<class N>(In<N>) {
      const Vector<N> home = c.points.position<N>({i, {}});
      return less_equal(dot(home, home, c.m_size()), square(c.rho.as<N>() * c.epsilon.as<N>()));
    });
    if (!near) {
      report.reject("1.perturbation",
                    [&] { return "label " + std::to_string(i) + " is moved by more than perturbation epsilon"; });
    }
    check_facets(c, i, report);
    check_star(c, AffineChart(charts, i, reach), i, report);
    simplices += c.star_size(i);
  }
  return std::to_string(simplices) +
         " simplices in the charts of their vertices, protection >= " + rounded_down(c.protection.exact) +
         ", thickness >= " + rounded_down(c.thickness.exact) + ", circumradius <= " + rounded_up(c.circumradius.exact);
}

/// In the chart of j, the stars of j and of all labels of star(j). j is in the stars of just these.
std::string check_stable_stars_of_metric_field(const AffineCharts& charts, Report& report) {
  const Certificate& c = charts.certificate();
  if (!is_in_patches(c, c.reach_2s.exact)) {
    report.reject("2s.patch", [] { return "reach is not below patch_radius"; });
    return "";
  }
  const Quantity none(Rational(0));
  for (Label j = 0; j < c.n; ++j) {
    std::set<Label> centres;
    for (std::size_t s = 0; s < c.star_size(j); ++s) centres.insert(c.star_simplex(j, s), c.star_simplex(j, s) + c.m);
    const AffineChart chart(charts, j, c.reach_2s);
    for (const Label i : centres) {
      for (std::size_t s = 0; s < c.star_size(i); ++s) {
        const Label* others = c.star_simplex(i, s);
        // Once for each simplex: at its smallest label among the centres.
        if (std::any_of(others, others + c.m, [&](Label k) { return k < i && centres.contains(k); })) continue;
        const std::string which = star_text(c, i, others) + ", in the chart of " + std::to_string(j) + ",";
        std::string reason;
        std::vector<std::size_t> vertices = chart.find(i, others, reason);
        if (vertices.empty()) {
          report.reject("2s.reach", [&] { return which + " " + reason; });
          continue;
        }
        const AffineSimplex simplex(c, chart, std::move(vertices));
        if (simplex.is_degenerate()) {
          report.reject("2s.protection", [&] { return which + " is degenerate"; });
          continue;
        }
        const bool within = simplex.holds([&]<class N>(const Simplex<N>& t) {
          const Vector<N> centre = add(chart.position<N>(simplex.vertices()[0]), N(1), t.centre);
          return is_ball_within(dot(centre, centre, c.m_size()), t.radius_squared, c.reach_2s.as<N>());
        });
        if (!within) report.reject("2s.reach", [&] { return which + " has a ball beyond reach"; });
        check_protection(chart, simplex, none, report, "2s.protection", which);
      }
    }
  }
  return "every chart of a star sees the same star";
}

}  // namespace delcert::checker
