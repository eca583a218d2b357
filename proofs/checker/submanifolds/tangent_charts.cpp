#include "proofs/checker/submanifolds/tangent_charts.hpp"

#include <algorithm>

#include "proofs/checker/submanifolds/polyhedron.hpp"

namespace delcert::checker {
namespace {

Interval midpoint(const Interval& x) { return Interval::between(NearPoints::middle(x), NearPoints::middle(x)); }
Ball midpoint(const Ball& x) {
  Ball result;
  arb_get_mid_arb(result.raw(), x.raw());
  return result;
}

/// [-r, r] for an upper bound r.
Interval around_zero(const Interval& r) { return Interval::between(-r.upper(), r.upper()); }
Ball around_zero(const Ball& r) {
  Ball result;
  arb_add_error(result.raw(), r.raw());
  return result;
}

template <class N>
TangentChart<N> as_chart_of(const TangentChart<Rational>& exact) {
  return {as_numbers<N>(exact.centre), as_numbers<N>(exact.tangent), as_numbers<N>(exact.normal),
          as_numbers<N>(exact.Y),      as_numbers<N>(exact.W),       as_numbers<N>(exact.home)};
}

template <class N>
N exactly(double x) {
  if constexpr (std::is_same_v<N, Interval>) {
    return Interval::between(x, x);
  } else {
    N result;
    arb_set_d(result.raw(), x);
    return result;
  }
}

}  // namespace

TangentCharts::TangentCharts(const Certificate& c) : StarCharts(c), M_(*c.submanifold), values_(M_.map) {
  std::vector<Matrix<Interval>> centres;
  for (Label i = 0; i < c.n; ++i) {
    Budget::spend(2000 * M_.N);
    charts_.push_back(as_chart_of<Interval>(tangent_chart(c, i)));
    patches_.push_back(tangent_patch(c, i));
    for (const double size :
         {norm_above(charts_.back().Y), patches_.back().radius.filter.upper(), patches_.back().height.filter.upper(),
          c.displacement.filter.upper(), c.unit(i).upper()}) {
      if (!(size < 0x1p100)) throw Undecided("numbers of label " + std::to_string(i) + " are too large");
    }
    centres.push_back(charts_.back().centre);
  }
  near_centres_ = NearPoints(centres);
  if (M_.is_mesh()) polyhedron_ = std::make_unique<Polyhedron>(*this);
}

TangentCharts::~TangentCharts() = default;

template <class N>
TangentChart<N> TangentCharts::chart_as(Label i) const {
  if constexpr (std::is_same_v<N, Interval>) {
    return charts_[i];
  } else {
    return as_chart_of<N>(tangent_chart(c_, i));
  }
}

/// About the height of M over a place of the disc, by Newton's method: exact numbers that nothing is claimed of.
template <class N>
Matrix<N> TangentCharts::height_over(const TangentChart<N>& chart, const Matrix<N>& home, int steps) const {
  FormulaValues<N> values(M_.map);
  const Matrix<N> foot = chart.centre + chart.tangent * home;
  Matrix<N> z(M_.q, 1);
  for (int step = 0; step < steps; ++step) {
    values.evaluate(foot + chart.normal * z, 1);
    z = z - solution(chart.Y * values.jacobian() * chart.normal, chart.Y * values.value());
    for (std::size_t k = 0; k < z.size(); ++k) z[k] = midpoint(z[k]);
  }
  return z;
}

/// z is no farther from the height of M than |Y f| / (1 - theta), as in the cylinder the symmetric part of 1 - Y Df N
/// is at most theta.
template <class N>
Matrix<N> TangentCharts::point_as(Label j) const {
  const TangentChart<N> chart = chart_as<N>(j);
  if (M_.given) return chart.centre;
  if (polyhedron_) {
    Matrix<N> z(1, 1);
    z[0] = polyhedron_->home_height(j, chart);
    return chart.centre + chart.tangent * chart.home + chart.normal * z;
  }
  constexpr bool filter = std::is_same_v<N, Interval>;
  Matrix<N> z = height_over(chart, chart.home, filter ? 4 : 10);
  FormulaValues<N> values(M_.map);
  const Matrix<N> foot = chart.centre + chart.tangent * chart.home;
  values.evaluate(foot + chart.normal * z, 0);
  const N error = square_root(squared_norm(chart.Y * values.value())) / (N(1) - exactly<N>(theta_[j]));
  for (std::size_t k = 0; k < z.size(); ++k) {
    if (less(square(z[k]), square(patches_[j].height.as<N>())) != Verdict::proved)
      throw Undecided("the point of label " + std::to_string(j) + " is not found");
    z[k] = z[k] + around_zero(error);
  }
  return foot + chart.normal * z;
}

std::string TangentCharts::check(Report& report) {
  if (less(square(Rational(1) + c_.distortion.exact), Rational(1) + square(M_.slope.exact)) == Verdict::proved)
    report.reject("sub.distortion", [] { return "(1 + distortion)^2 is below 1 + slope^2"; });
  if (polyhedron_) polyhedron_->check_closed(report);
  for (Label i = 0; i < c_.n; ++i) {
    if (!c_.units.empty()) check_radii(i, report);
    if (polyhedron_) {
      polyhedron_->check_graph(i, report);
      theta_.push_back(0);
      lid_.push_back(polyhedron_->lid(i));
      continue;
    }
    check_box(i, report);
    check_graph(i, report);
  }
  if (!report.findings.empty()) return "";
  for (Label i = 0; i < c_.n; ++i) points_.push_back(point_as<Interval>(i));
  near_points_ = NearPoints(points_);
  if (polyhedron_) {
    parts_ = polyhedron_->check_cover(report);
    return std::to_string(c_.n) + " graphs, of slope <= " + rounded_up(M_.slope.exact) + "; they cover " +
           std::to_string(M_.facets.size()) + " facets in " + std::to_string(parts_) + " parts";
  }
  check_cover(report);
  return std::to_string(c_.n) + " graphs, of slope <= " + rounded_up(M_.slope.exact) + ", in " +
         std::to_string(cells_) + " cells; they cover the manifold in " + std::to_string(parts_) + " parts of the box";
}

/// sub.box: along every axis c + [-1, 1] (radius |row of tangent| + height |row of normal|_1) is inside.
void TangentCharts::check_box(Label i, Report& report) const {
  const bool inside = decide_enclosed([&]<class N>(In<N>) {
    const TangentChart<N> chart = chart_as<N>(i);
    Verdict result = Verdict::proved;
    for (std::size_t a = 0; a < M_.N; ++a) {
      N tangent(0), normal(0);
      for (std::size_t k = 0; k < M_.m; ++k) tangent = tangent + square(chart.tangent(a, k));
      for (std::size_t k = 0; k < M_.q; ++k) normal = normal + maximum(chart.normal(a, k), -chart.normal(a, k));
      const N half = patches_[i].radius.as<N>() * square_root(tangent) + patches_[i].height.as<N>() * normal;
      result = conjunction(result, conjunction(less(M_.box[a][0].as<N>(), chart.centre[a] - half),
                                               less(chart.centre[a] + half, M_.box[a][1].as<N>())));
    }
    return result;
  });
  if (!inside)
    report.reject("sub.box", [&] { return "the cylinder of label " + std::to_string(i) + " is not inside the box"; });
}

/// sub.radii: those of labels within 6 epsilon_i of i differ by radius_variation at most, as part of the lesser.
void TangentCharts::check_radii(Label i, Report& report) const {
  const Rational reach = Rational(6) * c_.at(i, c_.epsilon).exact;
  near_centres_.visit(charts_[i].centre, enclosure(reach).upper(), [&](Label j) {
    const Rational& one = c_.units[i].exact;
    const Rational& other = c_.units[j].exact;
    const Rational most = c_.radius_variation.exact + Rational(1);
    if (less_equal(one, most * other) == Verdict::proved && less_equal(other, most * one) == Verdict::proved) return;
    const Matrix<Rational> offset = tangent_chart(c_, j).centre - tangent_chart(c_, i).centre;
    if (less(square(reach), squared_norm(offset)) == Verdict::proved) return;
    report.reject("sub.radii", [&] {
      return "those of labels " + std::to_string(i) + " and " + std::to_string(j) +
             " differ by more than radius_variation";
    });
  });
}

ShownPoints<Ball> TangentCharts::shown(Label i, const Quantity& radius) const {
  const TangentChart<Interval>& chart = charts_[i];
  const double most = radius.filter.upper(), height = patches_[i].height.filter.upper();
  const double reach = square_root(square(Interval::between(0, most)) +
                                   Interval(static_cast<int>(M_.q)) * square(Interval::between(0, height)))
                           .upper();
  std::vector<std::pair<Label, Matrix<Interval>>> seen;
  near_points_.visit(chart.centre, reach, [&](Label j) {
    const Matrix<Interval> offset = points_[j] - chart.centre, place = transposed_times(chart.tangent, offset);
    if (squared_norm(place).lower() > (square(Interval::between(most, most))).upper()) return;
    const Matrix<Interval> heights = transposed_times(chart.normal, offset);
    Verdict low = Verdict::proved;  // a point of M is in the cylinder if it is lower than the lid
    for (std::size_t k = 0; k < M_.q; ++k) {
      const Interval lid = M_.given ? patches_[i].height.filter : Interval::between(lid_[i], lid_[i]);
      low = conjunction(low, conjunction(less(heights[k], lid), less(-heights[k], lid)));
    }
    if (low == Verdict::undecided)
      throw Undecided("whether the chart of " + std::to_string(i) + " shows label " + std::to_string(j));
    if (low == Verdict::proved) seen.emplace_back(j, place);
  });
  std::sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  ShownPoints<Ball> result(M_.m);
  std::vector<Label> labels;
  for (const auto& [j, place] : seen) {
    Vector<Interval> x{};
    for (std::size_t k = 0; k < M_.m; ++k) x[k] = place[k];
    result.add(j, x);
    labels.push_back(j);
  }
  result.exact = [this, i, labels = std::move(labels)](std::size_t at) {
    const TangentChart<Ball> in_balls = chart_as<Ball>(i);
    const Matrix<Ball> place = transposed_times(in_balls.tangent, point_as<Ball>(labels[at]) - in_balls.centre);
    Vector<Ball> x{};
    for (std::size_t k = 0; k < M_.m; ++k) x[k] = place[k];
    return x;
  };
  return result;
}

std::string TangentCharts::fault_of_patches(Level level) const {
  const Quantity reach = level == level_1 ? Quantity(c_.reach_1()) : c_.reach_2s;
  for (Label i = 0; i < c_.n; ++i) {
    if (less(c_.at(i, reach).exact, patches_[i].radius.exact) == Verdict::proved) continue;
    return std::string(level == level_1 ? "perturbation + 2 circumradius + protection" : "reach") +
           " is not below the patch radius of label " + std::to_string(i);
  }
  return "";
}

}  // namespace delcert::checker
