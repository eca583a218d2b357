#include <algorithm>
#include <iterator>
#include <limits>

#include "proofs/checker/core/frame.hpp"
#include "proofs/checker/submanifolds/tangent_charts.hpp"

namespace delcert::checker {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

Interval interval_of(double x) { return Interval::between(x, x); }

}  // namespace

/// What pairs of simplices are compared by.
struct GraphTriangulation::Straight {
  std::size_t s;
  Matrix<Interval> middle;                // the barycentre
  double margin = 0;                      // what has to be left of a distance
  double radius = 0;                      // about the barycentre: of the simplex, displacement and margin together
  std::vector<Matrix<Interval>> normals;  // along its plane those of its facets, and those of its first chart
};

/// Labels with the room that (lid) and (embedded) ask for: no simplex meets what is about them.
std::vector<bool> GraphTriangulation::roomy_labels() const {
  double widest = 0;                             // longest edge and displacement, of label i unit(i) times that
  std::vector<double> altitude(c_.n, no_bound);  // the least at the label, in its chart
  for (std::size_t s = 0; s < c_.simplex_count(); ++s)
    widest = std::max(widest, (interval_of(longest_[s]) / c_.least_unit(s) + c_.displacement.filter).upper());
  std::vector<double> moved(c_.n), around(c_.n);  // of the labels near: what they are moved by, displacement there
  for (Label i = 0; i < c_.n; ++i) {
    charts_.points().visit(charts_.point(i), widest * (c_.unit(i).upper() + c_.greatest_unit()), [&](Label v) {
      const double near = widest * (c_.unit(i).upper() + c_.unit(v).upper());
      if (!c_.units.empty() && square_root(squared_norm(charts_.point(v) - charts_.point(i))).lower() > near) return;
      moved[i] = std::max(moved[i], lateral(i, v) * most_climb_[v]);
      around[i] = std::max(around[i], (c_.displacement.filter * c_.unit(v)).upper());
    });
  }
  std::vector<bool> result(c_.n, true);
  for (std::size_t s = 0; s < c_.simplex_count(); ++s) {
    for (std::size_t k = 0; k <= c_.m_size(); ++k) {
      const Label i = c_.simplex(s)[k];
      altitude[i] = std::min(altitude[i], altitude_at(k, s));
      const double own = (c_.displacement.filter * c_.unit(i)).upper();
      for (int v = 0; v <= c_.m; ++v)
        if (!is_below_lid(i, c_.simplex(s)[v], 2 * own + around[i])) result[i] = false;
    }
  }
  const Interval rest = Interval(1) - c_.contraction.filter;
  for (Label i = 0; i < c_.n; ++i) {
    const Interval room = rest * interval_of(altitude[i]) / Interval(c_.m + 1) - Interval::between(0, 2 * moved[i]);
    if (!(room.lower() >= c_.at(i, c_.embedding_margin).filter.upper())) result[i] = false;
  }
  return result;
}

/// Labels of which 5i.star holds: on the star |E_i^T (H - X)| has a Lipschitz constant below 1.
std::vector<bool> GraphTriangulation::wide_stars() const {
  std::vector<double> room(c_.n, no_bound);
  for (std::size_t s = 0; s < c_.simplex_count(); ++s) {
    for (std::size_t k = 0; k <= c_.m_size(); ++k) {
      const Label i = c_.simplex(s)[k];
      double longest = 0;
      for (int v = 0; v <= c_.m; ++v) {
        const Matrix<Interval> edge = charts_.point(c_.simplex(s)[v]) - charts_.point(i);
        longest = std::max(longest, norm_above(transposed_times(charts_.chart(i).tangent, edge)));
      }
      const double swing = contraction_[s * (c_.m_size() + 1) + k] * longest;
      room[i] = std::min(room[i], (interval_of(altitude_at(k, s)) - interval_of(swing)).lower());
    }
  }
  std::vector<bool> result(c_.n);
  for (Label i = 0; i < c_.n; ++i) result[i] = room[i] >= c_.at(i, c_.embedding_margin).filter.upper();
  return result;
}

/// A lower bound of the altitude of the simplex at its k-th vertex, in the chart of that.
double GraphTriangulation::altitude_at(std::size_t k, std::size_t s) const {
  const Matrix<Interval> slopes = gradients(c_.simplex(s)[k], s);
  Interval steepness(0);
  for (std::size_t a = 0; a < c_.m_size(); ++a) steepness = steepness + square(slopes(k, a));
  return (Interval(1) / square_root(steepness)).lower();
}

/// No point of a simplex is farther from the barycentre than m / (m + 1) times the longest edge.
GraphTriangulation::Straight GraphTriangulation::straight(std::size_t s) const {
  const std::size_t corners = c_.m_size() + 1, N = charts_.manifold().N;
  const TangentChart<Interval>& chart = charts_.chart(c_.simplex(s)[0]);
  Straight result{s, Matrix<Interval>(N, 1), c_.at_simplex(s, c_.embedding_margin).filter.upper(), 0, {}};
  for (std::size_t v = 0; v < corners; ++v) result.middle = result.middle + charts_.point(c_.simplex(s)[v]);
  result.middle = (Interval(1) / Interval(c_.m + 1)) * result.middle;
  const Interval size = interval_of(longest_[s]) * Interval(c_.m) / Interval(c_.m + 1);
  result.radius = (size + displacement_[s] + interval_of(result.margin)).upper();
  const Matrix<Interval> along = chart.tangent * gradients(c_.simplex(s)[0], s).transposed();
  for (std::size_t v = 0; v < corners; ++v) result.normals.push_back(along.columns_from(v, 1));
  for (std::size_t k = 0; k < charts_.manifold().q; ++k) result.normals.push_back(chart.normal.columns_from(k, 1));
  return result;
}

/// Where a simplex is along a vector, from a place that both have; how far it is moved, and its margin.
GraphTriangulation::Extent GraphTriangulation::extent(const Matrix<Interval>& normal, const Matrix<Interval>& base,
                                                      const Straight& one) const {
  Extent result{no_bound, -no_bound, 0};
  for (int v = 0; v <= c_.m; ++v) {
    const Label label = c_.simplex(one.s)[v];
    const Interval height = transposed_times(normal, charts_.point(label) - base)[0];
    result.low = std::min(result.low, height.lower());
    result.high = std::max(result.high, height.upper());
    result.moved = std::max(result.moved, norm_above(transposed_times(normal, charts_.chart(label).W)) * climb_[one.s]);
  }
  return result;
}

/// Whether two simplices are apart along a vector by more than what both are moved by along it, and the margin. This
/// excludes the vector 0.
bool GraphTriangulation::are_apart_along(const Matrix<Interval>& normal, const Straight& a, const Straight& b) const {
  Budget::spend(30);
  const Matrix<Interval>& base = charts_.point(c_.simplex(a.s)[0]);
  const Extent here = extent(normal, base, a), there = extent(normal, base, b);
  const double moved = here.moved + there.moved + std::min(a.margin, b.margin) * norm_above(normal);
  // Rounded upwards, so that what is compared is not more than the distance.
  return -(here.high - there.low) > moved || -(there.high - here.low) > moved;
}

bool GraphTriangulation::are_apart(const Straight& a, const Straight& b) const {
  const Matrix<Interval> between = b.middle - a.middle;
  if (square_root(squared_norm(between)).lower() > a.radius + b.radius || are_apart_along(between, a, b)) return true;
  for (const Straight* one : {&a, &b}) {
    for (const Matrix<Interval>& normal : one->normals)
      if (are_apart_along(normal, a, b)) return true;
  }
  return false;
}

std::string GraphTriangulation::check_embedding(Report& report) {
  return "the complex is embedded, and isotopic to the manifold; " +
         (c_.isotopic_by_normals ? check_normals(report) : check_pairs(report));
}

/// Of the angles between the normal of a simplex and Df at its points, on the side of W, a lower bound, for one
/// equation.
double GraphTriangulation::least_cosine(std::size_t s) {
  const std::size_t m = c_.m_size(), N = charts_.manifold().N;
  const Label* labels = c_.simplex(s);
  core::Columns<Interval> edges{};  // and a place for what their form is of
  for (std::size_t k = 0; k < m; ++k) {
    for (std::size_t a = 0; a < N; ++a) edges[k][a] = charts_.point(labels[k + 1])[a] - charts_.point(labels[0])[a];
  }
  const Vector<Interval> form = core::cofactors(edges, N, m);
  Matrix<Interval> normal(N, 1);
  for (std::size_t a = 0; a < N; ++a) normal[a] = form[a];
  Interval side = transposed_times(normal, charts_.chart(labels[0]).W)[0];
  if (side.upper() < 0) {
    normal = Interval(-1) * normal;
    side = -side;
  }
  double result = side.lower() > 0 ? 1 : -1;
  for (const Matrix<Interval>& gradient : estimate(s).slopes) {
    const Interval across = (gradient * normal)[0];
    result = std::min(result, (across / square_root(squared_norm(gradient) * squared_norm(normal))).lower());
  }
  return result;
}

/// Rule 5i.normal: lines of steepest ascent cross all simplices, from the same side.
std::string GraphTriangulation::check_normals(Report& report) {
  for (std::size_t s = 0; s < c_.simplex_count(); ++s) {
    const double cosine = least_cosine(s);
    if (cosine >= c_.cosine.filter.upper()) continue;
    report.reject("5i.normal", [&] {
      const Label* labels = c_.simplex(s);
      return "the normal of simplex " + label_set(labels, labels + c_.m + 1) + " may be at an angle of cosine " +
             about(interval_of(cosine)) + " to a gradient";
    });
  }
  return "normals are at angles of cosine >= " + rounded_down(c_.cosine.exact) + " to gradients";
}

std::string GraphTriangulation::check_pairs(Report& report) {
  const std::vector<bool> roomy = roomy_labels(), wide = wide_stars();
  std::vector<Straight> all;
  std::vector<Matrix<Interval>> middles;
  for (std::size_t s = 0; s < c_.simplex_count(); ++s) {
    const Label* labels = c_.simplex(s);
    if (std::all_of(labels, labels + c_.m + 1, [&](Label i) { return roomy[i]; })) continue;
    all.push_back(straight(s));
    middles.push_back(all.back().middle);
  }
  const NearPoints near(middles);
  for (std::size_t a = 0; a < all.size(); ++a) {
    near.visit(middles[a], 2 * all[a].radius, [&](std::size_t b) {
      // Each pair once, with the larger one first.
      if (all[b].radius > all[a].radius || (all[b].radius == all[a].radius && b >= a)) return;
      const Label *of_a = c_.simplex(all[a].s), *of_b = c_.simplex(all[b].s);
      std::vector<Label> common;
      std::set_intersection(of_a, of_a + c_.m + 1, of_b, of_b + c_.m + 1, std::back_inserter(common));
      const auto reject = [&](const char* rule, const char* what) {
        report.reject(rule, [&] {
          return "simplices " + label_set(of_a, of_a + c_.m + 1) + " and " + label_set(of_b, of_b + c_.m + 1) + what;
        });
      };
      if (common.empty()) {
        if (!are_apart(all[a], all[b])) reject("5i.apart", " may meet on their way to the manifold");
      } else if (std::none_of(common.begin(), common.end(), [&](Label i) { return wide[i]; })) {
        reject("5i.star", " share no label whose star certainly keeps its form on the way to the manifold");
      }
    });
  }
  return "margin >= " + rounded_down(c_.embedding_margin.exact) + c_.of_lengths();
}

}  // namespace delcert::checker
