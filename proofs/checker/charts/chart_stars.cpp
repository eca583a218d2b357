#include "proofs/checker/charts/chart_stars.hpp"

#include <limits>
#include <set>

#include "proofs/checker/geometry/simplex.hpp"
#include "proofs/checker/levels/levels.hpp"
#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker {

std::string simplex_of_star(const Certificate& c, Label i, const Label* others) {
  return "simplex " + label_set(others, others + c.m) + " in the star of " + std::to_string(i);
}

namespace {

template <class E, class Predicate>
bool decide_by(const Predicate& predicate) {
  if constexpr (std::is_same_v<E, Rational>) {
    return decide(predicate);
  } else {
    return decide_enclosed(predicate);
  }
}

/// A simplex of a chart with its circumcentre.
template <class E>
class StarSimplex {
 public:
  StarSimplex(const Certificate& c, const ShownPoints<E>& chart, std::vector<std::size_t> vertices)
      : c_(c),
        chart_(chart),
        vertices_(std::move(vertices)),
        filter_(c.metric, chart.template positions<Interval>(vertices_)) {
    if constexpr (std::is_same_v<E, Rational>) {
      if (filter_.complete == Verdict::proved) return;
      const Simplex<Rational> known = exact();
      degenerate_ = known.complete != Verdict::proved;
      if (!degenerate_) filter_ = Simplex<Interval>(known);
    }
  }

  /// False as well where only enclosures are known.
  bool is_degenerate() const { return degenerate_; }
  const std::vector<std::size_t>& vertices() const { return vertices_; }
  const Simplex<Interval>& filter() const { return filter_; }
  bool is_vertex(std::size_t at) const { return std::find(vertices_.begin(), vertices_.end(), at) != vertices_.end(); }

  /// The predicate takes a Simplex<N> and returns a Verdict; undecided while it is not known that the simplex is not
  /// degenerate.
  template <class Predicate>
  bool holds(const Predicate& predicate) const {
    return decide_by<E>([&]<class N>(In<N>) {
      const auto decided = [&](const Simplex<N>& simplex) {
        return simplex.complete == Verdict::proved ? predicate(simplex) : Verdict::undecided;
      };
      if constexpr (std::is_same_v<N, Interval>) {
        return decided(filter_);
      } else {
        return decided(exact());
      }
    });
  }

 private:
  Simplex<E> exact() const { return Simplex<E>(c_.metric, chart_.template positions<E>(vertices_)); }

  const Certificate& c_;
  const ShownPoints<E>& chart_;
  std::vector<std::size_t> vertices_;
  Simplex<Interval> filter_;
  bool degenerate_ = false;
};

/// All points that the chart shows are farther than `margin` outside of the circumscribing sphere.
template <class E>
void check_protection(const ShownPoints<E>& chart, const StarSimplex<E>& simplex, const Quantity& margin,
                      Report& report, const char* rule, const std::string& which) {
  const std::size_t first = simplex.vertices()[0];
  // Farther from the origin than |C| + R + margin there is nothing to decide.
  double reach = std::numeric_limits<double>::infinity();
  const Simplex<Interval>& filter = simplex.filter();
  if (filter.complete == Verdict::proved) {
    const Vector<Interval> centre = add(chart.template position<Interval>(first), Interval(1), filter.centre);
    const double length = upper_root(dot(centre, centre, filter.dimension())),
                 radius = upper_root(filter.radius_squared);
    reach = (Interval::between(0, length) + Interval::between(0, radius) + margin.filter).upper();
  }
  for (std::size_t q = 0; q < chart.size(); ++q) {
    if (chart.distance(q) > reach || simplex.is_vertex(q)) continue;
    const bool clear = simplex.holds([&]<class N>(const Simplex<N>& s) {
      return is_clear<N>(s, chart.template position<N>(q) - chart.template position<N>(first), margin.as<N>());
    });
    if (clear) continue;
    report.reject(rule, [&] {
      return which + " has label " + std::to_string(chart.label(q)) + " within circumradius + " +
             rounded_up(margin.exact) + " of its circumcentre";
    });
  }
}

/// The checks of one level, chart after chart.
template <class E>
class StarsInCharts {
 public:
  StarsInCharts(const StarCharts<E>& charts, Report& report)
      : charts_(charts), c_(charts.certificate()), report_(report) {}

  void check(Label i) {
    const Quantity most = c_.at(i, shift_);
    const bool near = decide_by<E>([&]<class N>(In<N>) {
      const Vector<N> home = charts_.home(i, In<N>{});
      return less_equal(dot(home, home, c_.m_size()), square(most.as<N>()));
    });
    if (!near) {
      report_.reject("1.perturbation",
                     [&] { return "label " + std::to_string(i) + " is moved by more than perturbation epsilon"; });
    }
    check_facets(c_, i, report_);
    const ShownPoints<E> chart = charts_.shown(i, c_.at(i, reach_));
    for (std::size_t s = 0; s < c_.star_size(i); ++s) {
      const Label* others = c_.star_simplex(i, s);
      ++simplices;
      check_simplex(chart, i, others);
    }
  }

  /// In the chart of j, the stars of j and of all labels of star(j). j is in the stars of just these.
  void check_stable(Label j) {
    std::set<Label> centres;
    for (std::size_t s = 0; s < c_.star_size(j); ++s)
      centres.insert(c_.star_simplex(j, s), c_.star_simplex(j, s) + c_.m);
    const ShownPoints<E> chart = charts_.shown(j, c_.at(j, c_.reach_2s));
    for (const Label i : centres) {
      for (std::size_t s = 0; s < c_.star_size(i); ++s) {
        const Label* others = c_.star_simplex(i, s);
        // Once for each simplex: at its smallest label among the centres.
        if (std::any_of(others, others + c_.m, [&](Label k) { return k < i && centres.contains(k); })) continue;
        check_stable_simplex(chart, i, others, j);
      }
    }
  }
  std::int64_t simplices = 0;

 private:
  void check_simplex(const ShownPoints<E>& chart, Label i, const Label* others) {
    const std::string which = simplex_of_star(c_, i, others);
    Label missing = 0;
    std::vector<std::size_t> vertices = chart.find(i, others, missing);
    if (vertices.empty()) {
      return report_.reject("1.vertices",
                            [&] { return which + ": its chart does not show " + std::to_string(missing); });
    }
    const StarSimplex<E> simplex(c_, chart, std::move(vertices));
    if (simplex.is_degenerate()) return report_.reject("1.vertices", [&] { return which + " is degenerate"; });
    const Quantity most = c_.at(i, c_.circumradius);
    const bool small =
        simplex.holds([&]<class N>(const Simplex<N>& t) { return less_equal(t.radius_squared, square(most.as<N>())); });
    if (!small) {
      report_.reject("1.radius", [&] {
        return which + " has a squared circumradius of about " + about(simplex.filter().radius_squared);
      });
    }
    const bool thick = simplex.holds([&]<class N>(const Simplex<N>&) {
      return is_thick(c_.metric, chart.template positions<N>(simplex.vertices()), square(c_.thickness.as<N>()));
    });
    if (!thick)
      report_.reject("1.thickness", [&] { return which + " is thinner than " + rounded_up(c_.thickness.exact); });
    check_protection(chart, simplex, c_.at(i, c_.protection), report_, "1.protection", which);
  }

  void check_stable_simplex(const ShownPoints<E>& chart, Label i, const Label* others, Label j) {
    const std::string which = simplex_of_star(c_, i, others) + ", in the chart of " + std::to_string(j) + ",";
    Label missing = 0;
    std::vector<std::size_t> vertices = chart.find(i, others, missing);
    if (vertices.empty())
      return report_.reject("2s.reach", [&] { return which + " has no label " + std::to_string(missing); });
    const StarSimplex<E> simplex(c_, chart, std::move(vertices));
    if (simplex.is_degenerate()) return report_.reject("2s.protection", [&] { return which + " is degenerate"; });
    const Quantity reach = c_.at(j, c_.reach_2s);
    const bool within = simplex.holds([&]<class N>(const Simplex<N>& t) {
      const Vector<N> centre = add(chart.template position<N>(simplex.vertices()[0]), N(1), t.centre);
      return is_ball_within(dot(centre, centre, c_.m_size()), t.radius_squared, reach.as<N>());
    });
    if (!within) report_.reject("2s.reach", [&] { return which + " has a ball beyond reach"; });
    check_protection(chart, simplex, none_, report_, "2s.protection", which);
  }

  const StarCharts<E>& charts_;
  const Certificate& c_;
  Report& report_;
  const Quantity shift_{c_.rho.exact * c_.epsilon.exact}, reach_{c_.reach_1()}, none_{Rational(0)};
};

}  // namespace

template <class E>
std::string check_stars(const StarCharts<E>& charts, Report& report) {
  const std::string fault = charts.fault_of_patches(level_1);
  if (!fault.empty()) {
    report.reject("1.patch", [&] { return fault; });
    return "";
  }
  const Certificate& c = charts.certificate();
  const auto check = [&](std::size_t begin, std::size_t end, Report& found) {
    StarsInCharts<E> checker(charts, found);
    for (auto i = static_cast<Label>(begin); i < end; ++i) checker.check(i);
    return Counts{checker.simplices};
  };
  in_parts("1.perturbation, 1.facets, 1.vertices, 1.radius, 1.thickness, 1.protection", c.n, report, check, {"shown"});
  return "{shown} simplices in the charts of their vertices, protection >= " + rounded_down(c.protection.exact) +
         ", thickness >= " + rounded_down(c.thickness.exact) + ", circumradius <= " + rounded_up(c.circumradius.exact) +
         c.of_lengths();
}

template <class E>
std::string check_stable_stars(const StarCharts<E>& charts, Report& report) {
  const std::string fault = charts.fault_of_patches(level_2s);
  if (!fault.empty()) {
    report.reject("2s.patch", [&] { return fault; });
    return "";
  }
  const Certificate& c = charts.certificate();
  const auto check = [&](std::size_t begin, std::size_t end, Report& found) {
    StarsInCharts<E> checker(charts, found);
    for (auto j = static_cast<Label>(begin); j < end; ++j) checker.check_stable(j);
    return Counts{};
  };
  in_parts("2s.reach, 2s.protection", c.n, report, check);
  return "every chart of a star sees the same star";
}

template std::string check_stars(const StarCharts<Rational>& charts, Report& report);
template std::string check_stars(const StarCharts<Ball>& charts, Report& report);
template std::string check_stable_stars(const StarCharts<Rational>& charts, Report& report);
template std::string check_stable_stars(const StarCharts<Ball>& charts, Report& report);

}  // namespace delcert::checker
