#include "kernel/theorems/model_delaunay.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

struct ModelBall {
  double protection = 0;
  double circumradius = 0;
};

/// Bounds of the geodesic circumball of a simplex of the view, or why it is not certified.
template <int m>
std::optional<std::string> failure_of(const ChartView<m>& view, const PlaceSimplex<m>& simplex, ModelBall& result,
                                      std::size_t& witness) {
  const Curvature curvature = view.geometry().curvature;
  const double look_beyond = approximate_double(view.atlas().sampling_radius(view.chart())) / 2;
  const auto ball = look_at_ball<m>(view, LocalCoordinates::conformal, simplex, look_beyond);
  witness = view.size();
  if (!is_proved(ball.empty)) {
    witness = ball.witness;
    if (witness == view.size()) return "cannot be told from a degenerate geodesic simplex";
    return is_refuted(ball.empty) ? "has another lift in its closed geodesic circumball"
                                  : "is undecided in the linear model";
  }
  const double complete = view.complete_radius(LocalCoordinates::conformal);
  const FilterGuard guard;
  const auto& metric = view.filter_metric();
  const Filter squared_centre = metric.squared_norm(ball.centre);
  const Filter outermost = square_root(squared_centre) + square_root(ball.squared_radius);
  if (!is_proved(less(outermost, Filter::exactly(complete))))
    return "has a geodesic circumball that does not lie in the patch";
  // With E = |c|² − R² the ball of X has the radius ρ with tan ρ, ρ, tanh ρ = R/(1 + KE/4), below a right angle exactly
  // where the denominator is positive.
  const Filter denominator = Filter(1) + detail::times(curvature, (squared_centre - ball.squared_radius) / Filter(4));
  if (!is_proved(less(Filter(0), denominator))) return "has no geodesic circumball of a radius below a right angle";
  const Filter squared_tangent = ball.squared_radius / square(denominator);
  if (curvature == Curvature::negative && !is_proved(less(squared_tangent, Filter(1))))
    return "has no geodesic circumball";
  const Filter radius = square_root(squared_tangent) * arctangent_ratio(curvature, squared_tangent);
  result.circumradius = radius.upper();
  // The squared chord from the centre to a point of power p is 2/w·(tan²ρ/(1 + w) + p), w = √(1 + K tan²ρ).
  const Filter power = ball.least_power / denominator;
  const Filter root = square_root(Filter(1) + detail::times(curvature, squared_tangent));
  const Filter chord = Filter(2) / root * (squared_tangent / (Filter(1) + root) + power);
  const Filter gap = distance_of_chord(curvature, chord) - radius;
  // The ball lies within exp_o⁻¹(outermost) of the centre of the chart.
  const auto length = [&](const Filter& conformal) {
    return conformal * arctangent_ratio(curvature, square(conformal) / Filter(4));
  };
  const Filter room = length(Filter::exactly(complete)) - length(outermost);
  result.protection = minimum(gap, room).lower();
  if (!(result.protection > 0)) return "has a protection in the linear model too small for the filter";
  return std::nullopt;
}

template <int m>
class ModelCheck {
 public:
  /// The view is copied.
  ModelCheck(const ChartView<m>& empty_view, const ChartComplex<m>& complex) : complex_(complex), view_(empty_view) {
    report.protection = std::numeric_limits<double>::infinity();
  }

  /// The simplices whose smallest interior label is i.
  void look_from(Label i) {
    const auto mine = complex_.first_seen_from(i);
    if (mine.empty()) return;
    std::vector<StarFailure> failures;
    for (const double half_reach : view_.half_reaches()) {
      view_.look_by_halves(i, half_reach);
      failures.clear();
      bool blames_a_point = false;
      for (const auto& simplex : mine) blames_a_point = check(i, simplex, failures) || blames_a_point;
      if (failures.empty() || blames_a_point) break;
    }
    report.failures.insert(report.failures.end(), failures.begin(), failures.end());
  }

  ModelReport report;

 private:
  /// Whether a point is to blame for a failure.
  bool check(Label i, const ChartSimplex<m>& others, std::vector<StarFailure>& failures) {
    std::vector<Label> labels{i};
    for (const auto& seen : others) labels.push_back(label_of<m>(seen));
    PlaceSimplex<m> places;
    std::optional<std::string> reason;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      const auto place = view_.find(labels[corner]);
      if (!place) reason = "has a label that is not seen once";
      places[corner] = place.value_or(0);
    }
    ModelBall ball;
    std::size_t witness = view_.size();
    if (!reason) reason = failure_of<m>(view_, places, ball, witness);
    if (!reason) {
      report.protection = std::min(report.protection, ball.protection);
      report.circumradius = std::max(report.circumradius, ball.circumradius);
      return false;
    }
    std::string text = simplex_text(labels) + " " + *reason;
    if (witness < view_.size()) {
      text += ": label " + std::to_string(view_.label(witness).value);
      labels.push_back(view_.label(witness));
    }
    failures.push_back({i, std::move(text), std::move(labels)});
    return witness < view_.size();
  }

  const ChartComplex<m>& complex_;
  ChartView<m> view_;
};

}  // namespace

void ModelReport::include(ModelReport other) {
  protection = std::min(protection, other.protection);
  circumradius = std::max(circumradius, other.circumradius);
  std::move(other.failures.begin(), other.failures.end(), std::back_inserter(failures));
}

/// 4r < 2·inj.
void ModelReport::check_lifts(const ModelGeometry& geometry) {
  if (failures.empty() && Rational(2) * Rational::exactly(circumradius) >= geometry.injectivity_radius) {
    failures.push_back(
        {Label(0), "the largest circumradius is not below half the injectivity radius: lifts may be mistaken", {}});
  }
}

template <int m>
ModelReport check_circumballs(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry,
                              const ChartComplex<m>& complex, LabelRange labels, const Progress& progress) {
  const ChartView<m> empty_view(atlas, points, geometry);
  ModelReport all;
  all.protection = std::numeric_limits<double>::infinity();
  const auto look = [&](std::size_t first, std::size_t last) {
    ModelCheck<m> check(empty_view, complex);
    for (std::size_t at = first; at < last; ++at) {
      const Label label(labels.first + at);
      if (complex.is_interior(label)) check.look_from(label);
    }
    return std::move(check.report);
  };
  in_parts("certify geodesic circumballs", labels.size(), progress, look,
           [&all](ModelReport found) { all.include(std::move(found)); });
  return all;
}

template <int m>
ModelReport check_model_delaunay(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry,
                                 const ChartComplex<m>& complex, const Progress& progress) {
  ModelReport all = check_circumballs<m>(atlas, points, geometry, complex, all_labels_of(complex), progress);
  all.check_lifts(geometry);
  return all;
}

#define DELCERT_INSTANTIATE(m)                                                                            \
  template ModelReport check_circumballs<m>(const Atlas<m>&, const PointSet<m>&, const ModelGeometry&,    \
                                            const ChartComplex<m>&, LabelRange, const Progress&);         \
  template ModelReport check_model_delaunay<m>(const Atlas<m>&, const PointSet<m>&, const ModelGeometry&, \
                                               const ChartComplex<m>&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
