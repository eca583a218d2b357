#include <algorithm>
#include <limits>
#include <numeric>

#include "proofs/checker/tangent_charts.hpp"

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

/// What is known of f and W on a simplex. All numbers are upper bounds.
struct GraphTriangulation::Estimate {
  std::vector<Matrix<Interval>> slopes;  // Df at the vertices, by the second derivatives
  double bend = 0;                       // |D^2 f|
  double theta = 0;                      // |1 - Df W|
};

GraphTriangulation::GraphTriangulation(const TangentCharts& charts)
    : charts_(charts),
      c_(charts.certificate()),
      values_(charts.manifold().map),
      middle_values_(charts.manifold().map),
      displacement_(c_.displacement.filter.upper()),
      least_climb_(c_.n, unbounded),
      most_climb_(c_.n, 0) {}

double GraphTriangulation::lateral(Label i, Label v) const {
  return norm_above(transposed_times(charts_.chart(i).tangent, charts_.chart(v).W));
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
  for (std::size_t k = 0; k < N; ++k) box[k] = box[k] + Interval::between(-displacement_, displacement_);
  values_.evaluate(box, 2);
  middle_values_.evaluate(middle, 1);
  Estimate result;
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
    for (const Matrix<Interval>& slope : result.slopes) error = std::max(error, norm_above(one_less(slope * W)));
    result.theta = std::max(result.theta, error + result.bend * displacement_ * norm_above(W));
  }
  longest_.push_back(longest);
  climb_.push_back((above + greatest) * reciprocal_of_rest(result.theta));
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
  Matrix<Interval> edges(N, m);
  for (std::size_t k = 0; k < m; ++k) {
    const Matrix<Interval> edge = charts_.point(labels[k + 1]) - charts_.point(labels[0]);
    for (std::size_t a = 0; a < N; ++a) edges(a, k) = edge[a];
  }
  const Matrix<Interval> all = gradients(i, s);
  Matrix<Interval> inverse(m, m);  // of E_i^T edges
  for (std::size_t k = 0; k < m * m; ++k) inverse[k] = all[k + m];
  const Matrix<Interval> lifted = edges * inverse;
  double rise = 0, slope = 0, turn_squared = 0;
  for (const Matrix<Interval>& at : estimate.slopes) {
    rise = std::max(rise, norm_above(at * lifted));
    slope = std::max(slope, norm_above(at));
  }
  const double blur = estimate.bend * displacement_;
  rise += blur * norm_above(lifted);
  slope += blur;
  for (std::size_t l = 0; l < m; ++l) {
    Matrix<Interval> turn(N, charts_.manifold().q);
    for (std::size_t k = 0; k < m; ++k)
      turn = turn + inverse(k, l) * (charts_.chart(labels[k + 1]).W - charts_.chart(labels[0]).W);
    turn_squared += squared_norm(turn).upper();
  }
  const double unit = greatest_lateral(i, s) * reciprocal_of_rest(estimate.theta);
  return unit * rise + (1 + unit * slope) * std::sqrt(turn_squared) * climb_[s];
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

void GraphTriangulation::check_simplex(std::size_t s, Report& report) {
  const Label* labels = c_.simplex(s);
  const Estimate known = estimate(s);
  const auto reject = [&](const char* rule, const std::string& what) {
    report.reject(rule, [&] { return simplex_text(c_, s) + what; });
  };
  if (!(known.theta < 1)) reject("5.fibre", ": fibres about it may meet the manifold twice");
  double widest = 0;
  for (int k = 0; k <= c_.m; ++k) {
    const Label i = labels[k];
    widest = std::max(widest, norm_above(charts_.chart(i).W));
    most_climb_[i] = std::max(most_climb_[i], climb_[s]);
    least_climb_[i] = std::min(least_climb_[i], climb_[s]);
    bool inside = true;
    for (int v = 0; v <= c_.m; ++v) {
      const Matrix<Interval> place =
          transposed_times(charts_.chart(i).tangent, charts_.point(labels[v]) - charts_.chart(i).centre);
      inside = inside && norm_above(place) + displacement_ < charts_.patch(i).radius.filter.lower() &&
               is_below_lid(i, labels[v], displacement_);
    }
    if (!inside) reject("5.fibre", " is not within displacement of the patch of label " + std::to_string(i));
    const double contraction = contraction_in(i, s, known);
    if (!(contraction <= c_.contraction.filter.lower())) {
      reject("5.contract", ": in the chart of label " + std::to_string(i) + " the contraction may be " +
                               about(Interval::between(contraction, contraction)));
    }
  }
  const double moved = widest * climb_[s];
  if (!(moved <= c_.displacement.filter.lower()))
    reject("5.fibre", " may be moved by " + about(Interval::between(moved, moved)));
}

/// Every fibre over label k that meets the simplex is another one's: the place of k in the chart of the least label of
/// the simplex is farther from it than H moves along the chart, or k is too far, or too high.
bool GraphTriangulation::is_clear_of(Label k, std::size_t s) const {
  const Label* labels = c_.simplex(s);
  const Label j = labels[0];
  const Matrix<Interval> offset = charts_.point(k) - charts_.point(j);
  if (square_root(squared_norm(offset)).lower() > longest_[s] + 2 * displacement_) return true;
  const TangentChart<Interval>& chart = charts_.chart(j);
  const Matrix<Interval> height = transposed_times(chart.normal, offset);
  for (std::size_t a = 0; a < height.size(); ++a) {
    Interval low(0), high(0);  // of the vertices, relative to j
    for (int v = 1; v <= c_.m; ++v) {
      const Interval at = transposed_times(chart.normal, charts_.point(labels[v]) - charts_.point(j))[a];
      low = -maximum(-low, -at);
      high = maximum(high, at);
    }
    const Interval margin = Interval::between(0, 2 * displacement_);
    if ((height[a] - high - margin).lower() > 0 || (low - margin - height[a]).lower() > 0) return true;
  }
  double moved = greatest_lateral(j, s) * climb_[s];
  if (charts_.manifold().given) moved += lateral(j, k) * least_climb_[k];
  const Matrix<Interval> slopes = gradients(j, s), place = transposed_times(chart.tangent, offset);
  for (std::size_t v = 0; v <= c_.m_size(); ++v) {
    Interval coordinate(v == 0 ? 1 : 0), steepness(0);  // barycentric, and of its gradient
    for (std::size_t a = 0; a < c_.m_size(); ++a) {
      coordinate = coordinate + slopes(v, a) * place[a];
      steepness = steepness + square(slopes(v, a));
    }
    if (-coordinate.upper() > moved * upper_root(steepness)) return true;
  }
  return false;
}

/// 5.clear: each component of the complex has a label that is clear of all simplices but its own.
void GraphTriangulation::check_clear(Report& report) {
  std::vector<Label> parent(c_.n);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](Label k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (std::size_t s = 0; s < c_.simplex_count(); ++s) {
    for (int k = 1; k <= c_.m; ++k) parent[root(c_.simplex(s)[k])] = root(c_.simplex(s)[0]);
  }
  std::vector<bool> found(c_.n);
  for (Label k = 0; k < c_.n; ++k) {
    if (found[root(k)]) continue;
    bool clear = true;
    for (std::size_t s = 0; clear && s < c_.simplex_count(); ++s) {
      Budget::spend(5);
      clear = has(c_, s, k) || is_clear_of(k, s);
    }
    if (clear) found[root(k)] = true;
  }
  for (Label k = 0; k < c_.n; ++k) {
    if (found[root(k)]) continue;
    report.reject("5.clear", [&] {
      return "no label of the component of label " + std::to_string(k) + " is clear of the others";
    });
    return;
  }
}

std::string GraphTriangulation::check(Report& report) {
  for (std::size_t s = 0; s < c_.simplex_count(); ++s) check_simplex(s, report);
  check_clear(report);
  return "the map along normals is a homeomorphism, moves points by <= " + rounded_up(c_.displacement.exact) +
         " and in charts by a contraction with <= " + rounded_up(c_.contraction.exact);
}

std::string GraphTriangulation::check_embedding(Report& report) {
  const double longest = *std::max_element(longest_.begin(), longest_.end());
  std::vector<double> altitude(c_.n, unbounded);  // the least at the label, in its chart
  for (std::size_t s = 0; s < c_.simplex_count(); ++s) {
    for (std::size_t k = 0; k <= c_.m_size(); ++k) {
      const Label i = c_.simplex(s)[k];
      const Matrix<Interval> slopes = gradients(i, s);
      Interval steepness(0);
      for (std::size_t a = 0; a < c_.m_size(); ++a) steepness = steepness + square(slopes(k, a));
      altitude[i] = std::min(altitude[i], (Interval(1) / square_root(steepness)).lower());
      for (int v = 0; v <= c_.m; ++v) {
        if (is_below_lid(i, c_.simplex(s)[v], 3 * displacement_)) continue;
        report.reject("5i.lid", [&] {
          return simplex_text(c_, s) + " is not 3 displacement below the lid of label " + std::to_string(i);
        });
      }
    }
  }
  const Interval rest = Interval(1) - c_.contraction.filter;
  for (Label i = 0; i < c_.n; ++i) {
    double moved = 0;
    charts_.points().visit(charts_.point(i), 2 * longest + 2 * displacement_,
                           [&](Label v) { moved = std::max(moved, lateral(i, v) * most_climb_[v]); });
    const Interval room =
        rest * Interval::between(altitude[i], altitude[i]) / Interval(c_.m + 1) - Interval::between(0, 2 * moved);
    if (room.lower() >= c_.embedding_margin.filter.upper()) continue;
    report.reject("5i.embedded", [&] {
      return "at label " + std::to_string(i) + " the margin may be " +
             about(Interval::between(room.lower(), room.lower()));
    });
  }
  return "the complex is embedded, and isotopic to the manifold; margin >= " + rounded_down(c_.embedding_margin.exact);
}

}  // namespace delcert::checker
