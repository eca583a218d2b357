#include <algorithm>
#include <map>

#include "proofs/checker/core/all_charts.hpp"
#include "proofs/checker/core/core.hpp"
#include "proofs/checker/geometry/grid.hpp"
#include "proofs/checker/geometry/simplex.hpp"
#include "proofs/checker/levels/levels.hpp"
#include "proofs/checker/parts/parts.hpp"

namespace delcert::checker {
namespace {

/// One simplex of a star after the other; what they share is kept.
class StarChecker {
 public:
  /// `core`: where the lemmas on neighbours hold, else none.
  StarChecker(const Certificate& certificate, const Grid& grid, core::Core* core, Report& report)
      : c_(certificate), report_(report), grid_(grid), core_(core), chart_(0, c_.m_size(), Quantity(Rational(1))) {}

  void check(Label i) {
    ++stars;
    lifts_.clear();
    reach_ = c_.at(i, Quantity(Rational(2) * c_.circumradius.exact));
    if (c_.has_boundary()) check_facets(c_, i, report_);  // else core.facets
    if (core_ != nullptr) return check_by_neighbours(i);
    for (std::size_t s = 0; s < c_.star_size(i); ++s) {
      const Label* labels = c_.star_simplex(i, s);
      // A simplex is looked at from its smallest interior label; it is in the star of each of its interior labels.
      if (std::any_of(labels, labels + c_.m, [&](Label j) { return j < i && c_.interior[j]; })) continue;
      ++simplices;
      check_simplex(i, labels);
    }
  }
  std::int64_t stars = 0, simplices = 0;

 private:
  /// The nearest points to a circumcentre are neighbours of the vertices. With 1.patch the lifts that the core knows of
  /// are the only ones within 2 circumradius.
  void check_by_neighbours(Label i) {
    const auto& star = core_->complex().star;
    for (std::size_t at = 0; at < star.size(i); ++at) {
      const auto [s, place] = star.of(i)[at];
      if (place != 0) continue;
      ++simplices;
      const Label* labels = c_.simplex(s);
      const Label* end = labels + c_.m + 1;
      std::array<Quantity, 2> memory;
      const core::FlatSimplex& found = core_->flat()->of(s);
      const SimplexInSpace simplex{{}, found.radius, found.nearest, 1, found.altitude, found.longest};
      const bool fits = chart_.fits(simplex, c_.at_least(labels, end, c_.circumradius, memory[0]), c_.thickness,
                                    c_.at_least(labels, end, c_.protection, memory[1]));
      if (!is_decided(fits)) check_simplex(i, labels + 1);
    }
  }
  void check_simplex(Label i, const Label* labels) {
    const auto reject = [&](const char* rule, const auto& describe) {
      report_.reject(rule, [&] {
        return "simplex " + label_set(labels, labels + c_.m) + " in the star of " + std::to_string(i) + " " +
               describe();
      });
    };
    std::array<Label, 5> all{i};
    const Label* end = std::copy_n(labels, c_.m, all.begin() + 1);
    const Quantity circumradius = c_.at_least(all.data(), end, c_.circumradius);
    const Quantity protection = c_.at_least(all.data(), end, c_.protection);
    Vertices vertices{{i, {}}};
    for (int k = 0; k < c_.m; ++k) {
      if (!lifts_.contains(labels[k])) lifts_[labels[k]] = c_.points.lifts_within({i, {}}, labels[k], reach_, true);
      const std::vector<Lift>& found = lifts_[labels[k]];
      if (found.size() != 1) {
        return reject("1.vertices", [&] {
          return "has " + std::to_string(found.size()) + " lifts of " + std::to_string(labels[k]) +
                 " within 2 circumradius";
        });
      }
      vertices.push_back({labels[k], found[0]});
    }
    const auto exact = [&] { return Simplex<Rational>(c_.metric, c_.points.positions<Rational>(vertices)); };
    Simplex<Interval> filter(c_.metric, c_.points.positions<Interval>(vertices));
    if (filter.complete != Verdict::proved) {
      const Simplex<Rational> known = exact();
      if (known.complete != Verdict::proved) return reject("1.vertices", [] { return "is degenerate"; });
      filter = Simplex<Interval>(known);
    }
    const auto small = [&]<class N>(In<N>) {
      return less_equal(choose<N>(filter, exact).radius_squared, square(circumradius.as<N>()));
    };
    if (!decide(small))
      reject("1.radius", [&] { return "has a squared circumradius of about " + about(filter.radius_squared); });
    const auto thick = [&]<class N>(In<N>) {
      return is_thick(c_.metric, c_.points.positions<N>(vertices), square(c_.thickness.as<N>()));
    };
    if (!decide(thick)) reject("1.thickness", [&] { return "is thinner than " + rounded_up(c_.thickness.exact); });

    const Vector<Interval> origin = c_.points.position<Interval>(vertices[0]);
    const double reach = (Interval::between(0, upper_root(filter.radius_squared)) + protection.filter).upper();
    grid_.visit(add(origin, Interval(1), filter.centre), reach, [&](const Vertex& q) {
      if (std::find(vertices.begin(), vertices.end(), q) != vertices.end()) return;
      const auto clear = [&]<class N>(In<N>) {
        return is_clear<N>(choose<N>(filter, exact), c_.points.position<N>(q) - c_.points.position<N>(vertices[0]),
                           protection.as<N>());
      };
      if (decide(clear)) return;
      reject("1.protection", [&] {
        return "has " + to_string(q, c_.m) + " within circumradius + " + rounded_up(protection.exact) +
               " of its circumcentre";
      });
    });
  }

  template <class N, class Exact>
  static decltype(auto) choose(const Simplex<Interval>& filter, const Exact& exact) {
    if constexpr (std::is_same_v<N, Interval>) {
      return (filter);
    } else {
      return exact();
    }
  }

  const Certificate& c_;
  Report& report_;
  const Grid& grid_;
  core::Core* core_;
  const AllCharts chart_;
  Quantity reach_;
  std::map<Label, std::vector<Lift>> lifts_;  // within 2 circumradius of the centre of the star at hand
};

/// 2r + delta <= 8 epsilon, and every non-zero lattice vector is longer than 4r + 2 delta.
void check_patch(const Certificate& c, Report& report) {
  const Rational diameter = Rational(2) * c.circumradius.exact + c.protection.exact;
  if (less(Rational(8) * c.epsilon.exact, diameter) == Verdict::proved) {
    report.reject("1.patch", [] { return "2 circumradius + protection exceeds 8 epsilon"; });
  }
  const Lift lift = c.points.lattice_vector_within(Quantity(Rational(2) * diameter), true);
  if (lift == Lift{}) return;
  report.reject("1.patch", [&] {
    return "label " + to_string({0, lift}, c.m) + " is within 4 circumradius + 2 protection of label 0";
  });
}

}  // namespace

/// Every (m-1)-face of star(i) that contains i lies in exactly two simplices of star(i).
void check_facets(const Certificate& c, Label i, Report& report, const char* rule) {
  const auto m = static_cast<std::size_t>(c.m);
  std::vector<std::array<Label, 3>> facets;
  for (std::size_t s = 0; s < c.star_size(i); ++s) {
    const Label* labels = c.star_simplex(i, s);
    for (std::size_t omitted = 0; omitted < m; ++omitted) {
      auto& facet = facets.emplace_back();
      std::copy(labels + omitted + 1, labels + m, std::copy_n(labels, omitted, facet.begin()));
    }
  }
  std::sort(facets.begin(), facets.end());
  for (auto begin = facets.begin(), end = begin; begin != facets.end(); begin = end) {
    end = std::upper_bound(begin, facets.end(), *begin);
    if (end - begin == 2) continue;
    report.reject(rule, [&] {
      return "in the star of " + std::to_string(i) + ", " + std::to_string(end - begin) + " simplices have the face " +
             label_set(begin->data(), begin->data() + m - 1) + " and the label";
    });
  }
}

std::string check_level_1(const Certificate& c, core::Core* core, Report& report) {
  check_patch(c, report);
  if (!report.findings.empty()) return "";  // of lifts there may be any number
  const bool has_bounds = core != nullptr && core->is_delaunay_quotient() && core->flat() != nullptr;
  const Grid grid(c.points);
  const auto check = [&](std::size_t begin, std::size_t end, Report& found) {
    StarChecker checker(c, grid, has_bounds ? core : nullptr, found);
    for (auto i = static_cast<Label>(begin); i < end; ++i) {
      if (c.interior[i]) checker.check(i);
    }
    return Counts{checker.simplices, checker.stars};
  };
  in_parts("1.vertices, 1.radius, 1.thickness, 1.protection, 1.facets", c.n, report, check, {"simplices", "stars"});
  return "{simplices} simplices of {stars} stars, protection >= " + rounded_down(c.protection.exact) +
         ", thickness >= " + rounded_down(c.thickness.exact) + ", circumradius <= " + rounded_up(c.circumradius.exact) +
         c.of_lengths();
}

}  // namespace delcert::checker
