#include <algorithm>
#include <cmath>
#include <limits>

#include "proofs/checker/submanifolds/tangent_charts.hpp"

namespace delcert::checker {
namespace {

constexpr std::size_t most_parts_of_box = 4'000'000, most_parts_of_point = 1000;

double width(const Interval& x) { return x.upper() - x.lower(); }

Matrix<Interval> centre_of(const Matrix<Interval>& box) {
  Matrix<Interval> result(box.rows(), 1);
  for (std::size_t k = 0; k < box.size(); ++k) {
    result[k] = Interval::between(NearPoints::middle(box[k]), NearPoints::middle(box[k]));
  }
  return result;
}

std::string corners_of(const Matrix<Interval>& box) {
  std::string text;
  for (std::size_t k = 0; k < box.size(); ++k) {
    text += (k == 0 ? "[" : " x [") + about(Interval::between(box[k].lower(), box[k].lower())) + ", " +
            about(Interval::between(box[k].upper(), box[k].upper())) + "]";
  }
  return text;
}

}  // namespace

/// The search for points of M in the box that no chart shows.
struct TangentCharts::Cover {
  TangentCharts& charts;
  FormulaValues<Interval> values{charts.M_.map}, middle_values{charts.M_.map};
  double reach = 0, least = std::numeric_limits<double>::infinity();  // of the cylinders: greatest and least sizes

  explicit Cover(TangentCharts& all) : charts(all) {
    for (const TangentPatch& patch : charts.patches_) {
      const Interval size =
          square(patch.radius.filter) + Interval(static_cast<int>(charts.M_.q)) * square(patch.height.filter);
      reach = std::max(reach, upper_root(size));
      least = std::min({least, patch.radius.filter.lower(), patch.height.filter.lower()});
    }
  }

  /// Whether the box is certainly in the cylinder (proved), or certainly does not meet it (refuted).
  Verdict is_in(Label i, const Matrix<Interval>& box) const {
    const TangentChart<Interval>& chart = charts.charts_[i];
    const TangentPatch& patch = charts.patches_[i];
    const Matrix<Interval> offset = box - chart.centre;
    Verdict result = less(squared_norm(transposed_times(chart.tangent, offset)), square(patch.radius.filter));
    const Matrix<Interval> heights = transposed_times(chart.normal, offset);
    for (std::size_t k = 0; k < heights.size(); ++k) {
      result = conjunction(result, less(heights[k], patch.height.filter));
      result = conjunction(result, less(-heights[k], patch.height.filter));
    }
    return result;
  }

  /// Whether a chart shows all of the box: the nearest one, or, if the box is small, any.
  bool is_shown(const Matrix<Interval>& box, bool is_small) const {
    double nearest = std::numeric_limits<double>::infinity();
    Label best = 0;
    const Matrix<Interval> middle = centre_of(box);
    charts.near_centres_.visit(middle, reach / 4, [&](Label i) {
      const double distance = squared_norm(charts.charts_[i].centre - middle).upper();
      if (distance < nearest) {
        nearest = distance;
        best = i;
      }
    });
    if (std::isfinite(nearest) && is_in(best, box) == Verdict::proved) return true;
    bool found = false;
    if (is_small) {
      charts.near_centres_.visit(middle, reach, [&](Label i) { found = found || is_in(i, box) == Verdict::proved; });
    }
    return found;
  }

  /// Whether some function is certainly not 0 in the box: by the values of its operations, or about its middle.
  bool is_missed(const Matrix<Interval>& box) {
    values.evaluate(box, 1);
    const auto excludes_zero = [](const Interval& x) { return x.lower() > 0 || x.upper() < 0; };
    for (std::size_t f = 0; f < charts.M_.q; ++f)
      if (excludes_zero(values.value(f))) return true;
    const Matrix<Interval> middle = centre_of(box);
    middle_values.evaluate(middle, 0);
    const Matrix<Interval> centred = middle_values.value() + values.jacobian() * (box - middle);
    for (std::size_t f = 0; f < charts.M_.q; ++f)
      if (excludes_zero(centred[f])) return true;
    return false;
  }

  /// The axis along which a function changes most, or nearly the widest one. The values are those of is_missed.
  std::size_t axis_to_halve(const Matrix<Interval>& box) const {
    const Matrix<Interval> slopes = values.jacobian();
    std::vector<double> weight(box.size(), 0x1p-2);
    for (std::size_t f = 0; f < slopes.rows(); ++f) {
      double most = 0;
      const auto size = [&](std::size_t k) { return std::max(slopes(f, k).upper(), -slopes(f, k).lower()); };
      for (std::size_t k = 0; k < box.size(); ++k) most = std::max(most, size(k));
      for (std::size_t k = 0; k < box.size() && most > 0 && std::isfinite(most); ++k)
        weight[k] = std::max(weight[k], size(k) / most);
    }
    std::size_t best = 0;
    for (std::size_t k = 1; k < box.size(); ++k)
      best = weight[k] * width(box[k]) > weight[best] * width(box[best]) ? k : best;
    return best;
  }

  /// A point of M near the box that certainly no chart shows, with what is around it; nothing if none is found.
  /// x + V s, |s| <= r, has a zero if |f(x)| <= (1 - |1 - Df V|) r.
  Matrix<Interval> point_not_shown(const Matrix<Interval>& box) {
    const auto none = Matrix<Interval>();
    Matrix<Interval> x = centre_of(box), V;
    for (int step = 0; step < 6; ++step) {
      middle_values.evaluate(x, 1);
      const Matrix<Interval> slopes = middle_values.jacobian(), rows = slopes.transposed();
      V = rows * solution(slopes * rows, one_less(Matrix<Interval>(charts.M_.q, charts.M_.q)));
      x = centre_of(x - V * middle_values.value());
    }
    middle_values.evaluate(x, 0);
    const double error = norm_above(middle_values.value()), r = 2 * error + 0x1p-100;
    Matrix<Interval> around(charts.M_.q, 1);
    for (std::size_t k = 0; k < around.size(); ++k) around[k] = Interval::between(-r, r);
    const Matrix<Interval> place = x + V * around;
    middle_values.evaluate(place, 1);
    if (!(norm_above(one_less(middle_values.jacobian() * V)) <= 0.5 && error <= r / 2)) return none;
    for (std::size_t k = 0; k < place.size(); ++k) {
      if (less(charts.M_.box[k][0].filter, place[k]) != Verdict::proved) return none;
      if (less(place[k], charts.M_.box[k][1].filter) != Verdict::proved) return none;
    }
    bool shown = false;
    charts.near_centres_.visit(place, reach, [&](Label i) { shown = shown || is_in(i, place) != Verdict::refuted; });
    return shown ? none : place;
  }
};

/// sub.cover: every part of the box has no point of M, or is in the cylinder of a chart.
void TangentCharts::check_cover(Report& report) {
  Cover cover(*this);
  Matrix<Interval> whole(M_.N, 1);
  for (std::size_t k = 0; k < M_.N; ++k)
    whole[k] = Interval::between(M_.box[k][0].filter.lower(), M_.box[k][1].filter.upper());
  std::vector<Matrix<Interval>> open{whole};
  const auto undecided = [](const Matrix<Interval>& part) {
    throw Undecided("whether the manifold has a point that no chart shows in the box " + corners_of(part));
  };
  for (; !open.empty(); ++parts_) {
    const Matrix<Interval> part = std::move(open.back());
    open.pop_back();
    if (parts_ == most_parts_of_box + most_parts_of_point * c_.n) undecided(part);
    if (cover.is_missed(part)) continue;
    double widest = 0;
    for (std::size_t k = 0; k < M_.N; ++k) widest = std::max(widest, width(part[k]));
    const bool is_small = widest < cover.least;
    if (widest < cover.reach && cover.is_shown(part, is_small)) continue;
    if (is_small && widest < cover.least / 4) {
      const Matrix<Interval> place = cover.point_not_shown(part);
      if (place.size() != 0) {
        report.reject("sub.cover",
                      [&] { return "the manifold has a point in " + corners_of(place) + " that no chart shows"; });
        return;
      }
      if (widest < cover.least * 0x1p-8) undecided(part);
    }
    const std::size_t axis = cover.axis_to_halve(part);
    const double middle = NearPoints::middle(part[axis]);
    open.push_back(part);
    open.back()[axis] = Interval::between(part[axis].lower(), middle);
    open.push_back(part);
    open.back()[axis] = Interval::between(middle, part[axis].upper());
  }
}

}  // namespace delcert::checker
