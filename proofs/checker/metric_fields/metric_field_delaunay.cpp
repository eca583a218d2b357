#include "proofs/checker/certificate/metric_field.hpp"
#include "proofs/checker/metric_fields/metric_field_levels.hpp"

namespace delcert::checker {
namespace {

/// What has to be at least the margin: by how much powers of points are positive, less what the metric may change.
Rational stability(const Certificate& c) {
  const Rational& kappa = c.metric_field->metric_distortion.exact;
  const Rational& edge = c.edge.exact;
  const Rational less_one = Rational(1) - kappa;
  const Rational h = Rational(4) * kappa * square(c.circumradius.exact / less_one);
  const Rational ratio = Rational(2) * (Rational(1) + kappa) * c.circumradius.exact /
                         (less_one * Rational(c.m) * c.thickness.exact * edge);
  return (edge + c.protection.exact) * c.protection.exact - Rational(c.m + 1) * h * (Rational(1) + ratio);
}

template <class N>
Verdict has_edge(const Metric& metric, const std::vector<Vector<N>>& vertices, const N& length) {
  N longest(0);
  for (const Vector<N>& x : vertices) {
    for (const Vector<N>& y : vertices) longest = maximum(longest, metric.squared_length(x - y));
  }
  return less_equal(square(length), longest);
}

}  // namespace

std::string check_delaunay_of_metric_field(const FieldCharts& charts, Report& report) {
  const Certificate& c = charts.certificate();
  if (less_equal(c.stability_margin.exact, stability(c)) != Verdict::proved)
    report.reject("4.stability", [] { return "the metric may change powers of points by too much for this margin"; });
  const Quantity reach(c.reach_1());
  for (Label i = 0; i < c.n; ++i) {
    const ShownPoints<Rational> chart = charts.shown(i, reach);
    for (std::size_t s = 0; s < c.star_size(i); ++s) {
      const Label* others = c.star_simplex(i, s);
      Label missing = 0;
      const std::vector<std::size_t> vertices = chart.find(i, others, missing);
      if (vertices.empty()) continue;  // 1.vertices has it
      const bool long_enough =
          decide([&]<class N>(In<N>) { return has_edge(c.metric, chart.positions<N>(vertices), c.edge.as<N>()); });
      if (long_enough) continue;
      report.reject("4.edge", [&] {
        return "all edges of simplex " + label_set(others, others + c.m) + " in the star of " + std::to_string(i) +
               " are shorter than " + rounded_up(c.edge.exact);
      });
    }
  }
  return "the Delaunay complex for the distance of the metric, stable by >= " + rounded_down(c.stability_margin.exact);
}

}  // namespace delcert::checker
