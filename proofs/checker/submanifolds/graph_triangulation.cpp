#include <algorithm>
#include <limits>
#include <numeric>

#include "proofs/checker/submanifolds/polyhedron.hpp"

namespace delcert::checker {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// 1 / (1 - x), from above. Rounding upwards, x - 1 is not below what it is.
double reciprocal_of_rest(double x) { return x < 1 ? 1 / -(x - 1) : unbounded; }

bool has(const Certificate& c, std::size_t s, Label k) {
  return std::binary_search(c.simplex(s), c.simplex(s) + c.m + 1, k);
}

std::string simplex_text(const Certificate& c, std::size_t s) {
  return "simplex " + label_set(c.simplex(s), c.simplex(s) + c.m + 1);
}

}  // namespace

GraphTriangulation::GraphTriangulation(const TangentCharts& charts)
    : charts_(charts),
      c_(charts.certificate()),
      values_(charts.manifold().map),
      middle_values_(charts.manifold().map),
      least_climb_(c_.n, unbounded),
      most_climb_(c_.n, 0) {
  for (std::size_t s = 0; s < c_.simplex_count(); ++s)
    displacement_.push_back(c_.at_simplex(s, c_.displacement).filter);
}

double GraphTriangulation::lateral(Label i, Label v) const {
  return spectral_norm_above(transposed_times(charts_.chart(i).tangent, charts_.chart(v).W));
}

double GraphTriangulation::greatest_lateral(Label i, std::size_t s) const {
  double result = 0;
  for (int k = 0; k <= c_.m; ++k) result = std::max(result, lateral(i, c_.simplex(s)[k]));
  return result;
}

bool GraphTriangulation::is_below_lid(Label i, Label v, double margin) const {
  const Matrix<Interval> heights =
      transposed_times(charts_.chart(i).normal, charts_.point(v) - charts_.chart(i).centre);
  Verdict result = Verdict::proved;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const Interval room = charts_.patch(i).height.filter - Interval::between(margin, margin);
    result = conjunction(result, conjunction(less(heights[k], room), less(-heights[k], room)));
  }
  return result == Verdict::proved;
}

std::vector<GraphTriangulation::Estimate> GraphTriangulation::estimates(std::size_t s) {
  if (charts_.polyhedron() != nullptr) return estimates_of_mesh(s);
  return {estimate(s)};
}

std::vector<GraphTriangulation::Estimate> GraphTriangulation::estimates_of_mesh(std::size_t s) const {
  const Label* labels = c_.simplex(s);
  const std::size_t corners = c_.m_size() + 1;
  Estimate common;
  double height = 0;
  std::vector<Estimate> result;
  for (std::size_t v = 0; v < corners; ++v) {
    Polyhedron::Hull hull = charts_.polyhedron()->hull(labels[v], s, displacement_[s].upper());
    height = std::max(height, hull.height);
    for (std::size_t w = 0; w < corners; ++w) {
      const Matrix<Interval>& W = charts_.chart(labels[w]).W;
      for (const Matrix<Interval>& slope : hull.slopes)
        common.theta = std::max(common.theta, spectral_norm_above(one_less(slope * W)));
      common.longest = std::max(common.longest, norm_above(charts_.point(labels[v]) - charts_.point(labels[w])));
    }
    result.emplace_back().slopes = std::move(hull.slopes);
  }
  for (Estimate& one : result) {
    one.around = displacement_[s].upper();
    one.theta = common.theta;
    one.longest = common.longest;
    one.climb = height * reciprocal_of_rest(common.theta);
  }
  return result;
}

/// On the displacement-neighbourhood of the simplex Df is a convex combination of what it is at the vertices, by one
/// and the same value of D^2 f there, and at most |D^2 f| displacement away from it.
GraphTriangulation::Estimate GraphTriangulation::estimate(std::size_t s) {
  const Label* labels = c_.simplex(s);
  const std::size_t corners = c_.m_size() + 1, N = charts_.manifold().N, q = charts_.manifold().q;
  Matrix<Interval> box = charts_.point(labels[0]), middle(N, 1);
  double longest = 0;
  for (std::size_t v = 0; v < corners; ++v) {
    const Matrix<Interval>& x = charts_.point(labels[v]);
    for (std::size_t k = 0; k < N; ++k)
      box[k] = Interval::between(std::min(box[k].lower(), x[k].lower()), std::max(box[k].upper(), x[k].upper()));
    for (std::size_t w = 0; w < v; ++w) longest = std::max(longest, norm_above(x - charts_.point(labels[w])));
  }
  for (std::size_t k = 0; k < N; ++k) {
    middle[k] = Interval::between(NearPoints::middle(box[k]), NearPoints::middle(box[k]));
  }
  values_.evaluate(box, 2);
  const double above = height_between(s, longest);
  Estimate result;
  result.around = displacement_[s].upper();
  for (std::size_t k = 0; k < N; ++k) box[k] = box[k] + Interval::between(-result.around, result.around);
  values_.evaluate(box, 2);
  middle_values_.evaluate(middle, 1);
  Interval bend(0);
  for (std::size_t f = 0; f < q; ++f) {
    for (std::size_t k = 0; k < N; ++k) {
      for (std::size_t l = 0; l < N; ++l) bend = bend + square(values_.second(f, k, l));
    }
  }
  result.bend = upper_root(bend);
  if (!(result.bend < unbounded)) throw Undecided("the equations are not defined around " + simplex_text(c_, s));
  double greatest = 0;  // of |f| at the vertices
  for (std::size_t v = 0; v < corners; ++v) {
    Matrix<Interval> slope = middle_values_.jacobian();
    const Matrix<Interval> offset = charts_.point(labels[v]) - middle;
    for (std::size_t f = 0; f < q; ++f) {
      for (std::size_t k = 0; k < N; ++k) {
        for (std::size_t l = 0; l < N; ++l) slope(f, k) = slope(f, k) + values_.second(f, k, l) * offset[l];
      }
    }
    result.slopes.push_back(std::move(slope));
    if (!charts_.manifold().given) continue;
    middle_values_.evaluate(charts_.point(labels[v]), 0);
    greatest = std::max(greatest, norm_above(middle_values_.value()));
    middle_values_.evaluate(middle, 1);
  }
  for (std::size_t v = 0; v < corners; ++v) {
    const Matrix<Interval>& W = charts_.chart(labels[v]).W;
    double error = 0;
    for (const Matrix<Interval>& slope : result.slopes)
      error = std::max(error, spectral_norm_above(one_less(slope * W)));
    result.theta = std::max(result.theta, error + result.bend * result.around * spectral_norm_above(W));
  }
  result.longest = longest;
  result.climb = (above + greatest) * reciprocal_of_rest(result.theta);
  return result;
}

/// An upper bound of |f| on a simplex at whose vertices f is 0, from its second derivatives in the box around it, which
/// are at hand: the sum of t_v h_v h_v^T over the vertices, at x - h_v, is that of t_v t_w e e^T over the edges.
double GraphTriangulation::height_between(std::size_t s, double longest) const {
  const std::size_t N = charts_.manifold().N, q = charts_.manifold().q;
  const Label* labels = c_.simplex(s);
  Interval spread(0);
  std::vector<Interval> middle;
  for (std::size_t f = 0; f < q; ++f) {
    for (std::size_t k = 0; k < N; ++k) {
      for (std::size_t l = 0; l < N; ++l) {
        const Interval& x = values_.second(f, k, l);
        const double at = NearPoints::middle(x);
        middle.push_back(Interval::between(at, at));
        spread = spread + square(x - middle.back());
      }
    }
  }
  double most = 0;
  for (int v = 1; v <= c_.m; ++v) {
    for (int w = 0; w < v; ++w) {
      const Matrix<Interval> edge = charts_.point(labels[v]) - charts_.point(labels[w]);
      Interval squared(0);
      for (std::size_t f = 0; f < q; ++f) {
        Interval bent(0);
        for (std::size_t k = 0; k < N; ++k) {
          for (std::size_t l = 0; l < N; ++l) bent = bent + middle[(f * N + k) * N + l] * edge[k] * edge[l];
        }
        squared = squared + square(bent);
      }
      most = std::max(most, upper_root(squared));
    }
  }
  const double m = c_.m;
  return (most + upper_root(spread) * longest * longest) * (m / (4 * (m + 1)));
}

/// An upper bound of |D(E_i^T H (E_i^T)^-1) - 1| on the simplex, H the map to M.
double GraphTriangulation::contraction_in(Label i, std::size_t s, const Estimate& estimate) const {
  const Label* labels = c_.simplex(s);
  const std::size_t m = c_.m_size(), N = charts_.manifold().N;
  const Matrix<Interval> all = gradients(i, s), rising = lifted(i, s);
  double rise = 0, slope = 0, turn_squared = 0;
  for (const Matrix<Interval>& at : estimate.slopes) {
    rise = std::max(rise, spectral_norm_above(at * rising));
    slope = std::max(slope, spectral_norm_above(at));
  }
  const double blur = estimate.bend * estimate.around;
  rise += blur * norm_above(rising);
  slope += blur;
  for (std::size_t l = 0; l < m; ++l) {
    Matrix<Interval> turn(N, charts_.manifold().q);
    for (std::size_t k = 0; k < m; ++k)
      turn = turn + all(k + 1, l) * (charts_.chart(labels[k + 1]).W - charts_.chart(labels[0]).W);
    turn_squared += squared_norm(turn).upper();
  }
  const double unit = greatest_lateral(i, s) * reciprocal_of_rest(estimate.theta);
  return unit * rise + (1 + unit * slope) * std::sqrt(turn_squared) * estimate.climb;
}

Matrix<Interval> GraphTriangulation::gradients(Label i, std::size_t s) const {
  const std::size_t m = c_.m_size();
  const Matrix<Interval>& first = charts_.point(c_.simplex(s)[0]);
  Matrix<Interval> edges(m, m), result(m + 1, m);
  for (std::size_t k = 0; k < m; ++k) {
    const Matrix<Interval> edge =
        transposed_times(charts_.chart(i).tangent, charts_.point(c_.simplex(s)[k + 1]) - first);
    for (std::size_t a = 0; a < m; ++a) edges(a, k) = edge[a];
  }
  const Matrix<Interval> inverse = solution(transposed_times(edges, edges), edges.transposed());
  for (std::size_t k = 0; k < m; ++k) {
    for (std::size_t a = 0; a < m; ++a) {
      result(k + 1, a) = inverse(k, a);
      result(0, a) = result(0, a) - inverse(k, a);
    }
  }
  return result;
}

Matrix<Interval> GraphTriangulation::lifted(Label i, std::size_t s) const {
  const std::size_t m = c_.m_size(), N = charts_.manifold().N;
  const Matrix<Interval> slopes = gradients(i, s);
  Matrix<Interval> result(N, m);
  for (std::size_t k = 1; k <= m; ++k) {
    const Matrix<Interval> edge = charts_.point(c_.simplex(s)[k]) - charts_.point(c_.simplex(s)[0]);
    for (std::size_t a = 0; a < N; ++a) {
      for (std::size_t b = 0; b < m; ++b) result(a, b) = result(a, b) + edge[a] * slopes(k, b);
    }
  }
  return result;
}

void GraphTriangulation::check_simplex(std::size_t s, Report& report) {
  const Label* labels = c_.simplex(s);
  const std::vector<Estimate> all = estimates(s);
  const Estimate& known = all[0];
  longest_.push_back(known.longest);
  climb_.push_back(known.climb);
  const auto reject = [&](const char* rule, const std::string& what) {
    report.reject(rule, [&] { return simplex_text(c_, s) + what; });
  };
  if (!(known.theta < 1)) reject("5.fibre", ": fibres about it may meet the manifold twice");
  double widest = 0;
  for (int k = 0; k <= c_.m; ++k) {
    const Label i = labels[k];
    widest = std::max(widest, spectral_norm_above(charts_.chart(i).W));
    most_climb_[i] = std::max(most_climb_[i], climb_[s]);
    least_climb_[i] = std::min(least_climb_[i], climb_[s]);
    bool inside = true;
    for (int v = 0; v <= c_.m; ++v) {
      const Matrix<Interval> place =
          transposed_times(charts_.chart(i).tangent, charts_.point(labels[v]) - charts_.chart(i).centre);
      inside = inside && norm_above(place) + known.around < charts_.patch(i).radius.filter.lower() &&
               is_below_lid(i, labels[v], known.around);
    }
    if (!inside) reject("5.fibre", " is not within displacement of the patch of label " + std::to_string(i));
    const double contraction = contraction_in(i, s, all[all.size() == 1 ? 0 : static_cast<std::size_t>(k)]);
    contraction_.push_back(contraction);
    if (!(contraction <= c_.contraction.filter.lower())) {
      reject("5.contract", ": in the chart of label " + std::to_string(i) + " the contraction may be " +
                               about(Interval::between(contraction, contraction)));
    }
  }
  const double moved = widest * climb_[s];
  if (!(moved <= displacement_[s].lower()))
    reject("5.fibre", " may be moved by " + about(Interval::between(moved, moved)));
}

/// Every fibre over label k that meets the simplex is another one's: the place of k in the chart of the least label of
/// the simplex is farther from it than H moves along the chart, or k is too far, or too high.
bool GraphTriangulation::is_clear_of(Label k, std::size_t s) const {
  const Label* labels = c_.simplex(s);
  const Label j = labels[0];
  const Matrix<Interval> offset = charts_.point(k) - charts_.point(j);
  const double around = displacement_[s].upper() + (c_.displacement.filter * c_.unit(k)).upper();
  if (square_root(squared_norm(offset)).lower() > longest_[s] + around) return true;
  const TangentChart<Interval>& chart = charts_.chart(j);
  const Matrix<Interval> height = transposed_times(chart.normal, offset);
  for (std::size_t a = 0; a < height.size(); ++a) {
    Interval low(0), high(0);  // of the vertices, relative to j
    for (int v = 1; v <= c_.m; ++v) {
      const Interval at = transposed_times(chart.normal, charts_.point(labels[v]) - charts_.point(j))[a];
      low = -maximum(-low, -at);
      high = maximum(high, at);
    }
    const Interval margin = Interval::between(0, around);
    if ((height[a] - high - margin).lower() > 0 || (low - margin - height[a]).lower() > 0) return true;
  }
  double moved = greatest_lateral(j, s) * climb_[s];
  if (charts_.manifold().given) moved += lateral(j, k) * least_climb_[k];
  return is_beside(j, k, s, moved);
}

bool GraphTriangulation::is_beside(Label i, Label k, std::size_t s, double by) const {
  const Matrix<Interval> slopes = gradients(i, s),
                         place = transposed_times(charts_.chart(i).tangent,
                                                  charts_.point(k) - charts_.point(c_.simplex(s)[0]));
  for (std::size_t v = 0; v <= c_.m_size(); ++v) {
    Interval coordinate(v == 0 ? 1 : 0), steepness(0);  // barycentric, and of its gradient
    for (std::size_t a = 0; a < c_.m_size(); ++a) {
      coordinate = coordinate + slopes(v, a) * place[a];
      steepness = steepness + square(slopes(v, a));
    }
    if (-coordinate.upper() > by * upper_root(steepness)) return true;
  }
  return false;
}

std::string GraphTriangulation::check(Report& report) {
  for (std::size_t s = 0; s < c_.simplex_count(); ++s) check_simplex(s, report);
  require_clear_labels(
      c_, "5.clear",
      [&](Label k, const std::vector<Label>&) {
        for (std::size_t s = 0; s < c_.simplex_count(); ++s) {
          Budget::spend(5);
          if (!has(c_, s, k) && !is_clear_of(k, s)) return false;
        }
        return true;
      },
      report);
  return "the map along normals is a homeomorphism, moves points by <= " + rounded_up(c_.displacement.exact) +
         " and in charts by a contraction with <= " + rounded_up(c_.contraction.exact);
}

}  // namespace delcert::checker
