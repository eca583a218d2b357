#include <algorithm>
#include <functional>
#include <limits>
#include <memory>

#include "proofs/checker/submanifolds/tangent_charts.hpp"

namespace delcert::checker {
namespace {

constexpr std::size_t most_cells_of_chart = std::size_t{1} << 14;
/// theta is at most this, so that points are known well enough.
constexpr double most_theta = 1 - 0x1p-10, most_theta_at_once = 0.875;

Interval point_at(double x) { return Interval::between(x, x); }

/// From the middle to the farther end.
double half_width(const Interval& x) {
  const double middle = NearPoints::middle(x);
  return std::max(x.upper() - middle, middle - x.lower());
}

/// Makes x smaller; false if nothing remains.
bool clip_to(const Interval& room, Interval& x) {
  if (x.upper() < room.lower() || room.upper() < x.lower()) return false;
  x = Interval::between(std::max(x.lower(), room.lower()), std::min(x.upper(), room.upper()));
  return true;
}

/// At s = |y| / radius the slope of M is at most slope p(s), and so its height above that over the origin at most
/// slope radius P(s), P' = p.
Interval steepness_at(const Interval& s) { return (Interval(1) + Interval(7) * s) / Interval(8); }
Interval rise_to(const Interval& s) { return s * (Interval(2) + Interval(7) * s) / Interval(16); }

double norm_below(const Matrix<Interval>& a) { return square_root(squared_norm(a)).lower(); }

/// What sums of u_k a_k may be, of which the first m numbers u have a length of at most `across`, the others of at most
/// `above`.
class Spread {
 public:
  Spread(const std::vector<Matrix<Interval>>& a, std::size_t m) {
    Matrix<Interval> middles[2] = {Matrix<Interval>(a[0].size(), m), Matrix<Interval>(a[0].size(), a.size() - m)};
    Interval rests[2] = {Interval(0), Interval(0)};
    for (std::size_t k = 0; k < a.size(); ++k) {
      const std::size_t part = k < m ? 0 : 1, column = k < m ? k : k - m;
      for (std::size_t at = 0; at < a[k].size(); ++at) {
        known_ = known_ && half_width(a[k][at]) < std::numeric_limits<double>::infinity();
        if (!known_) return;
        middles[part](at, column) = point_at(NearPoints::middle(a[k][at]));
        rests[part] = rests[part] + square(a[k][at] - middles[part](at, column));
      }
    }
    for (std::size_t part = 0; part < 2; ++part) {
      size_[part] = spectral_norm_above(middles[part]);
      rest_[part] = upper_root(rests[part]);
    }
    // No product is greater than that of the norms.
    mixed_ = std::min(spectral_norm_above(transposed_times(middles[0], middles[1])), size_[0] * size_[1]);
  }

  /// Of the middles M and M' of the two parts |M u + M' u'|^2 is at most |M|^2 |u|^2 + |M'|^2 |u'|^2 + 2 |M^T M'| |u|
  /// |u'|, in the norm of Frobenius; of the rest the bound is that of Cauchy and Schwarz.
  double norm_within(double across, double above) const {
    if (!known_) return std::numeric_limits<double>::infinity();
    const double first = size_[0] * across, second = size_[1] * above;
    return std::sqrt(first * first + second * second + 2 * mixed_ * across * above) + rest_[0] * across +
           rest_[1] * above;
  }

 private:
  bool known_ = true;
  double size_[2] = {0, 0}, rest_[2] = {0, 0}, mixed_ = 0;
};

std::vector<Matrix<Interval>> times(const Matrix<Interval>& a, std::vector<Matrix<Interval>> of) {
  for (Matrix<Interval>& b : of) b = a * b;
  return of;
}

/// (a + a^T) / 2. If that of 1 - a has a norm of at most t < 1, then <v, a v> >= (1 - t) |v|^2: a is invertible, and
/// |a^-1| <= 1 / (1 - t).
Matrix<Interval> symmetric_part(const Matrix<Interval>& a) { return point_at(0.5) * (a + a.transposed()); }
std::vector<Matrix<Interval>> symmetric_parts(std::vector<Matrix<Interval>> of) {
  for (Matrix<Interval>& a : of) a = symmetric_part(a);
  return of;
}

}  // namespace

/// How Df N and Df E change along each axis of a chart, in a cell of its cylinder.
struct TangentCharts::Drift {
  std::vector<Matrix<Interval>> normal, tangent;
};

/// A box of the coordinates (y, z) of a chart, and what is known of the drift in it.
struct TangentCharts::Cell {
  Matrix<Interval> place;
  std::shared_ptr<const Drift> drift;
};

/// What is asked of a cell: with Df N and Df E at its middle, whether it holds in the cell (proved), or does not hold
/// at its middle (refuted); and how much of the error each axis contributes.
using Question = std::function<Verdict(const TangentCharts::Cell& cell, const Matrix<Interval>& normal,
                                       const Matrix<Interval>& tangent, std::vector<double>& weight)>;

Matrix<Interval> TangentCharts::position_of(Label i, const Matrix<Interval>& place) const {
  Matrix<Interval> result = charts_[i].centre;
  for (std::size_t a = 0; a < M_.N; ++a) {
    for (std::size_t k = 0; k < M_.N; ++k)
      result[a] = result[a] + place[k] * (k < M_.m ? charts_[i].tangent(a, k) : charts_[i].normal(a, k - M_.m));
  }
  return result;
}

/// From the second derivatives in the box around the cell.
std::shared_ptr<const TangentCharts::Drift> TangentCharts::drift_in(Label i, const Matrix<Interval>& place) {
  const TangentChart<Interval>& chart = charts_[i];
  values_.evaluate(position_of(i, place), 2);
  Drift result;
  for (std::size_t axis = 0; axis < M_.N; ++axis) {
    Matrix<Interval> change(M_.q, M_.N);
    for (std::size_t f = 0; f < M_.q; ++f) {
      for (std::size_t j = 0; j < M_.N; ++j) {
        Interval sum(0);
        for (std::size_t l = 0; l < M_.N; ++l)
          sum = sum + values_.second(f, j, l) * (axis < M_.m ? chart.tangent(l, axis) : chart.normal(l, axis - M_.m));
        change(f, j) = sum;
      }
    }
    result.normal.push_back(change * chart.normal);
    result.tangent.push_back(change * chart.tangent);
  }
  return std::make_shared<const Drift>(std::move(result));
}

/// Whether the answer is yes in all cells, into which the box is divided where it is not known: no if it is refuted
/// somewhere. `clip` makes a cell smaller, to what matters of it, and says whether that is anything.
bool TangentCharts::holds_in_cells(Label i, Matrix<Interval> box, const std::function<bool(Matrix<Interval>&)>& clip,
                                   const Question& question) {
  std::vector<Cell> open{{box, drift_in(i, box)}};
  for (std::size_t looked_at = 0; !open.empty(); ++looked_at, ++cells_) {
    if (looked_at == most_cells_of_chart)
      throw Undecided("whether the manifold is a graph in the chart of label " + std::to_string(i));
    Cell cell = std::move(open.back());
    open.pop_back();
    if (!clip(cell.place)) continue;
    Matrix<Interval> middle(M_.N, 1);
    for (std::size_t k = 0; k < M_.N; ++k) middle[k] = point_at(NearPoints::middle(cell.place[k]));
    values_.evaluate(position_of(i, middle), 1);
    const Matrix<Interval> slopes = values_.jacobian(), normal = slopes * charts_[i].normal,
                           tangent = slopes * charts_[i].tangent;
    std::vector<double> weight(M_.N);
    Verdict verdict = question(cell, normal, tangent, weight);
    if (verdict == Verdict::undecided && looked_at > 0) {
      cell.drift = drift_in(i, cell.place);
      verdict = question(cell, normal, tangent, weight);
    }
    if (verdict == Verdict::refuted) return false;
    if (verdict == Verdict::proved) continue;
    const auto widest = static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
    const Interval side = cell.place[widest];
    cell.place[widest] = Interval::between(side.lower(), middle[widest].upper());
    open.push_back(cell);
    cell.place[widest] = Interval::between(middle[widest].lower(), side.upper());
    open.push_back(std::move(cell));
  }
  return true;
}

/// The symmetric part of 1 - Y Df N from what it is in the middle of the cylinder and from the second derivatives in
/// all of it; at most most_theta_at_once, or nothing is known.
bool TangentCharts::has_fibres_at_once(Label i, double& theta) {
  const Matrix<Interval>& Y = charts_[i].Y;
  const std::vector<Matrix<Interval>> changes = symmetric_parts(times(Y, drift_in(i, cylinder(i))->normal));
  values_.evaluate(charts_[i].centre, 1);
  const Interval highest = square_root(Interval(static_cast<int>(M_.q))) * patches_[i].height.filter;
  const double most = norm_above(symmetric_part(one_less(Y * values_.jacobian() * charts_[i].normal))) +
                      Spread(changes, M_.m).norm_within(patches_[i].radius.filter.upper(), highest.upper());
  if (!(most <= most_theta_at_once)) return false;
  theta = most;
  ++cells_;
  return true;
}

/// The rule of the slopes from Df at (0, z), |z - z_0| <= blur, and from the second derivatives in a box around the
/// region of the rule. With A and B, Df N and Df E at (0, z), the symmetric part of 1 - A^-1 Df N is at most e, and
/// |A^-1 Df E| <= b, where e and b are numbers and norms of (|y|, |z - z_0|) that grow with either, |y| = s radius.
/// What slope p(s) (1 - e) is above b is concave in s: it is positive if it is at the origin and at the rim.
bool TangentCharts::is_flat_at_once(Label i, const Matrix<Interval>& z, const Interval& blur) {
  const Interval slope = M_.slope.filter, radius = patches_[i].radius.filter;
  const Interval off = square_root(Interval(static_cast<int>(M_.q))) * blur;
  const auto height_at = [&](const Interval& s) { return slope * radius * rise_to(s) + off; };
  Matrix<Interval> region = cylinder(i), foot(M_.N, 1);
  const double most = height_at(Interval(1)).upper();
  for (std::size_t k = M_.m; k < M_.N; ++k) {
    foot[k] = z[k - M_.m];
    region[k] = foot[k] + Interval::between(-most, most);
  }
  const std::shared_ptr<const Drift> drift = drift_in(i, region);
  values_.evaluate(position_of(i, foot), 1);
  const Matrix<Interval> slopes = values_.jacobian(), normal = slopes * charts_[i].normal,
                         inverse = solution(charts_[i].Y * normal, charts_[i].Y);
  const Spread turns(symmetric_parts(times(inverse, drift->normal)), M_.m), rises(times(inverse, drift->tangent), M_.m);
  const double defect = norm_above(symmetric_part(one_less(inverse * normal))),
               rise = norm_above(inverse * (slopes * charts_[i].tangent));
  const auto is_below = [&](const Interval& s) {
    const double across = (s * radius).upper(), above = height_at(s).upper();
    const double e = defect + turns.norm_within(across, above), b = rise + rises.norm_within(across, above);
    return e < 1 && less(point_at(b), slope * steepness_at(s) * (Interval(1) - point_at(e))) == Verdict::proved;
  };
  if (!is_below(Interval(0)) || !is_below(Interval(1))) return false;
  ++cells_;
  return true;
}

/// The symmetric part of 1 - Y Df N is below 1 in the cylinder. Gives a bound of it.
bool TangentCharts::check_fibres(Label i, double& theta) {
  if (has_fibres_at_once(i, theta)) return true;
  const Matrix<Interval>& Y = charts_[i].Y;
  return holds_in_cells(
      i, cylinder(i), [&](Matrix<Interval>& place) { return clip_to_disc(i, place); },
      [&](const Cell& cell, const Matrix<Interval>& normal, const Matrix<Interval>&, std::vector<double>& weight) {
        const Matrix<Interval> error = symmetric_part(one_less(Y * normal));
        double most = norm_above(error);
        for (std::size_t k = 0; k < M_.N; ++k) {
          weight[k] = half_width(cell.place[k]) * norm_above(symmetric_part(Y * cell.drift->normal[k]));
          most += weight[k];
        }
        if (most <= most_theta) {
          theta = std::max(theta, most);
          return Verdict::proved;
        }
        return is_middle_in_disc(i, cell.place) && norm_below(error) >= 1 ? Verdict::refuted : Verdict::undecided;
      });
}

/// |(Df N)^-1 Df E| <= slope p(s) where |z - z_0| <= slope radius P(s), s = |y| / radius, for all z_0 in a box. With A
/// and B the two at the middle of a cell and R = A^-1 B, at other places they are A + a and B + b, and the quotient is
/// R + (1 + A^-1 a)^-1 A^-1 (b - a R).
bool TangentCharts::check_slopes(Label i, const Matrix<Interval>& foot) {
  const Interval slope = M_.slope.filter, radius = patches_[i].radius.filter;
  const auto share = [&](const Matrix<Interval>& place) {  // s
    Interval squared(0);
    for (std::size_t k = 0; k < M_.m; ++k) squared = squared + square(place[k]);
    return square_root(squared) / radius;
  };
  const auto clip = [&](Matrix<Interval>& place) {
    if (!clip_to_disc(i, place)) return false;
    const double most = (slope * radius * rise_to(share(place))).upper();
    for (std::size_t k = M_.m; k < M_.N; ++k) {
      if (!clip_to(foot[k - M_.m] + Interval::between(-most, most), place[k])) return false;
    }
    return true;
  };
  return holds_in_cells(
      i, cylinder(i), clip,
      [&](const Cell& cell, const Matrix<Interval>& normal, const Matrix<Interval>& tangent,
          std::vector<double>& weight) {
        const Matrix<Interval> inverse = solution(charts_[i].Y * normal, charts_[i].Y), rise = inverse * tangent;
        double error = 0, change = 0, change_up = 0;  // |A^-1 a|, |A^-1 (b - a R)|, and the part of it along z
        std::vector<Matrix<Interval>> changes;
        for (std::size_t k = 0; k < M_.N; ++k) {
          const double half = half_width(cell.place[k]);
          changes.push_back(inverse * (cell.drift->tangent[k] - cell.drift->normal[k] * rise));
          error += half * norm_above(inverse * cell.drift->normal[k]);
          weight[k] = half * norm_above(changes[k]);
          change += weight[k];
          if (k >= M_.m) change_up += weight[k];
        }
        if (error < 1 && is_flat_at_corners(i, cell.place, rise, changes, change_up + error * change / -(error - 1)))
          return Verdict::proved;
        if (!(error < 1)) {
          for (std::size_t k = 0; k < M_.N; ++k)
            weight[k] = half_width(cell.place[k]) * norm_above(inverse * cell.drift->normal[k]);
        }
        Matrix<Interval> middle = cell.place;
        Interval height(0);
        for (std::size_t k = 0; k < M_.N; ++k) {
          middle[k] = point_at(NearPoints::middle(cell.place[k]));
          if (k >= M_.m) height = height + square(middle[k] - foot[k - M_.m]);
        }
        const Interval s = share(middle);
        const bool in_cone = less(height, square(slope * radius * rise_to(s))) == Verdict::proved;
        return in_cone && is_middle_in_disc(i, cell.place) && norm_below(rise) > (slope * steepness_at(s)).upper()
                   ? Verdict::refuted
                   : Verdict::undecided;
      });
}

/// Whether |R + sum of d_k times the k-th change| + more <= slope p(|y| / radius) in a cell, d = y less its middle. For
/// a vector u of length at most 1, |y| >= u y: with u y on the right, the left side less the right one is convex in y.
bool TangentCharts::is_flat_at_corners(Label i, const Matrix<Interval>& place, const Matrix<Interval>& rise,
                                       const std::vector<Matrix<Interval>>& changes, double more) const {
  double length = 0;  // of the middle
  for (std::size_t k = 0; k < M_.m; ++k) length += NearPoints::middle(place[k]) * NearPoints::middle(place[k]);
  length = std::sqrt(length) * (1 + 0x1p-40);
  for (std::size_t corner = 0; corner < std::size_t{1} << M_.m; ++corner) {
    Matrix<Interval> at = rise;
    Interval along(0);
    for (std::size_t k = 0; k < M_.m; ++k) {
      const double middle = NearPoints::middle(place[k]);
      const Interval y = point_at((corner >> k & 1U) != 0 ? place[k].upper() : place[k].lower());
      at = at + (y - point_at(middle)) * changes[k];
      if (length > 0) along = along + point_at(middle) * y / point_at(length);
    }
    const Interval least = M_.slope.filter * steepness_at(along / patches_[i].radius.filter);
    if (!(norm_above(at) + more <= least.lower())) return false;
  }
  return true;
}

Matrix<Interval> TangentCharts::cylinder(Label i) const {
  Matrix<Interval> result(M_.N, 1);
  for (std::size_t k = 0; k < M_.N; ++k) {
    const double half = (k < M_.m ? patches_[i].radius : patches_[i].height).filter.upper();
    result[k] = Interval::between(-half, half);
  }
  return result;
}

/// Makes the places y smaller, to a box around those of the disc; false if there are none.
bool TangentCharts::clip_to_disc(Label i, Matrix<Interval>& place) const {
  for (std::size_t axis = 0; axis < M_.m; ++axis) {
    Interval room = square(patches_[i].radius.filter);
    for (std::size_t k = 0; k < M_.m; ++k) room = k == axis ? room : room - square(place[k]);
    if (room.upper() < 0) return false;
    const double most = upper_root(room);
    if (!clip_to(Interval::between(-most, most), place[axis])) return false;
  }
  return true;
}

bool TangentCharts::is_middle_in_disc(Label i, const Matrix<Interval>& place) const {
  Interval squared(0);
  for (std::size_t k = 0; k < M_.m; ++k) squared = squared + square(point_at(NearPoints::middle(place[k])));
  return less(squared, square(patches_[i].radius.filter)) == Verdict::proved;
}

/// sub.graph: U_i is a graph over the disc.
void TangentCharts::check_graph(Label i, Report& report) {
  const TangentChart<Interval>& chart = charts_[i];
  const Interval height = patches_[i].height.filter;
  theta_.push_back(0);
  lid_.push_back(height.lower());
  Matrix<Interval> foot = height_over(chart, Matrix<Interval>(M_.m, 1), 4);
  const Interval blur_size = point_at(0x1p-20) * height, blur = Interval::between(-1, 1) * blur_size;
  Matrix<Interval> blurred = foot;
  Interval greatest(0);
  for (std::size_t k = 0; k < M_.q; ++k) {
    blurred[k] = foot[k] + blur;
    greatest = maximum(greatest, maximum(foot[k], -foot[k]));
  }
  const auto error_at = [&](const Matrix<Interval>& z) {
    values_.evaluate(chart.centre + chart.normal * z, 0);
    return square_root(squared_norm(chart.Y * values_.value()));
  };
  // Without a zero near this place, none of the cones about it says anything.
  const bool is_near = less(greatest, height) == Verdict::proved && error_at(foot).upper() < blur.upper();
  if (!is_near) {
    // All of the fibre over the origin is within the root of q times the height of the centre.
    const Interval least = error_at(Matrix<Interval>(M_.q, 1));
    const Interval most = Interval(2) * square_root(Interval(static_cast<int>(M_.q))) * height;
    if (less(most, least) != Verdict::proved)
      throw Undecided("whether the chart of label " + std::to_string(i) +
                      " has a point of the manifold over its centre");
  }
  const auto reject = [&](const char* what) {
    report.reject("sub.graph", [&] { return "the chart of label " + std::to_string(i) + what; });
  };
  double theta = 0;
  if (!check_fibres(i, theta)) return reject(" has fibres that may meet the manifold twice");
  if (!is_near) return reject(" has no point of the manifold over its centre");
  theta_[i] = theta;
  const Interval error = error_at(foot) / (Interval(1) - Interval::between(theta, theta));
  if (!(error.upper() <= blur.upper()))
    throw Undecided("whether the chart of label " + std::to_string(i) + " has a point of the manifold over its centre");
  const Interval rim = greatest + Interval::between(-error.upper(), error.upper()) +
                       M_.slope.filter * patches_[i].radius.filter * rise_to(Interval(1));
  const Verdict open = less(rim, height);
  if (!is_flat_at_once(i, foot, blur_size) && !check_slopes(i, blurred))
    return reject(" has a greater slope than stated");
  if (open == Verdict::refuted) return reject(" has its lid too low");
  if (open == Verdict::undecided)
    throw Undecided("whether the lid of the chart of label " + std::to_string(i) + " is high enough");
  lid_[i] = NearPoints::middle(Interval::between(rim.upper(), height.lower()));
}

}  // namespace delcert::checker
