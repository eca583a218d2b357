#include <algorithm>
#include <limits>
#include <map>

#include "proofs/checker/submanifolds/tangent_charts.hpp"

namespace delcert::checker {
namespace {

std::string bound_text(double x) { return about(Interval::between(x, x)); }

}  // namespace

/// 6.bilipschitz and 6.normal of a simplex, in the best of the charts of its vertices.
void GraphTriangulation::check_stretch(std::size_t s, Report& report) {
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const Label* labels = c_.simplex(s);
  const std::vector<Estimate> all = estimates(s);
  double least = 0, greatest = unbounded, turn = unbounded, thinnest = unbounded;
  for (int k = 0; k <= c_.m; ++k) {
    const Estimate& known = all[all.size() == 1 ? 0 : static_cast<std::size_t>(k)];
    const double blur = known.bend * known.around;
    const TangentChart<Interval>& chart = charts_.chart(labels[k]);
    const Matrix<Interval> rising = lifted(labels[k], s);
    const double contraction = contraction_in(labels[k], s, known);
    // E^T rising is 1.
    const double lift = upper_root(Interval(1) + squared_norm(transposed_times(chart.normal, rising)));
    double slope = 0, error = 0, rise = 0;
    for (const Matrix<Interval>& at : known.slopes) {
      slope = std::max(slope, norm_above(chart.Y * at * chart.tangent));
      error = std::max(error, norm_above(one_less(chart.Y * at * chart.normal)));
      rise = std::max(rise, spectral_norm_above(at * rising));
    }
    slope += blur * norm_above(chart.Y);
    error += blur * norm_above(chart.Y);
    rise += blur * lift;
    thinnest = std::min(thinnest, spectral_norm_above(chart.W));
    if (!(contraction < 1 && error < 1 && known.theta < 1)) continue;
    const auto rest_of = [](double x) { return Interval(1) - Interval::between(x, x); };
    least = std::max(least, (rest_of(contraction) / Interval::between(lift, lift)).lower());
    const double steep = (Interval::between(slope, slope) / rest_of(error)).upper();
    greatest = std::min(greatest, (1 + contraction) * upper_root(Interval(1) + square(Interval::between(0, steep))));
    turn = std::min(turn, (Interval::between(rise, rise) / rest_of(known.theta)).upper());
  }
  const auto name = [&] { return "simplex " + label_set(labels, labels + c_.m + 1); };
  if (!(least >= c_.least_stretch.filter.upper() && greatest <= c_.greatest_stretch.filter.lower())) {
    report.reject("6.bilipschitz", [&] {
      return name() + " may change lengths by factors from " + bound_text(least) + " to " + bound_text(greatest);
    });
  }
  if (!(turn * thinnest <= c_.normal.filter.lower())) {
    report.reject("6.normal", [&] {
      return name() + " may be at an angle of sine " + bound_text(turn * thinnest) + " to the manifold";
    });
  }
}

/// 6.self-delaunay, of the straight triangles.
void GraphTriangulation::check_cotangents(Report& report) const {
  std::map<std::pair<Label, Label>, Interval> sums;  // over the two triangles at each edge
  for (std::size_t s = 0; s < c_.simplex_count(); ++s) {
    const Label* labels = c_.simplex(s);
    for (std::size_t k = 0; k < 3; ++k) {
      const Label v = labels[k == 0 ? 1 : 0], w = labels[k == 2 ? 1 : 2];
      const Matrix<Interval> a = charts_.point(v) - charts_.point(labels[k]),
                             b = charts_.point(w) - charts_.point(labels[k]);
      const Interval along = transposed_times(a, b)[0];
      const Interval cotangent = along / square_root(squared_norm(a) * squared_norm(b) - square(along));
      const auto [at, is_new] = sums.try_emplace({v, w}, cotangent);
      if (!is_new) at->second = at->second + cotangent;
    }
  }
  for (const auto& [edge, sum] : sums) {
    if (less(c_.weight.filter, sum) == Verdict::proved) continue;
    report.reject("6.self-delaunay", [&] {
      return "the cotangents of the angles opposite to the edge of " + std::to_string(edge.first) + " and " +
             std::to_string(edge.second) + " have a sum of at most weight";
    });
  }
}

std::string GraphTriangulation::check_metric(Report& report) {
  for (std::size_t s = 0; s < c_.simplex_count(); ++s) check_stretch(s, report);
  if (c_.self_delaunay) check_cotangents(report);
  return std::string(c_.self_delaunay ? "the straight triangles are their own Delaunay triangulation; " : "") +
         "lengths change by factors within [" + rounded_down(c_.least_stretch.exact) + ", " +
         rounded_up(c_.greatest_stretch.exact) +
         "], angles to tangent planes have sines <= " + rounded_up(c_.normal.exact);
}

}  // namespace delcert::checker
