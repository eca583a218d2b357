#include "proofs/checker/submanifolds/chord_bend.hpp"

#include "proofs/checker/geometry/near_points.hpp"

namespace delcert::checker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// 1 / pi from above; the root of 12 from below and from above.
constexpr double wirtinger = 0.31831, low_root = 3.4641016, high_root = 3.4641017;

Interval of_double(double x) { return Interval::between(x, x); }
double size_above(const Interval& x) { return std::max(x.upper(), -x.lower()); }

Matrix<Interval> second_of(const FormulaValues<Interval>& values, std::size_t N) {
  Matrix<Interval> result(N, N);
  for (std::size_t a = 0; a < N; ++a) {
    for (std::size_t b = 0; b < N; ++b) result(a, b) = values.second(0, a, b);
  }
  return result;
}

}  // namespace

double ChartBend::excess(double d) const {
  const double spread = rate * d / low_root + size;
  return d * spread * spread / 2;
}

Distance ChartBend::distance(const Interval& squared, bool are_shown) const {
  if (!are_shown) return {infinity, {}};
  const double in_chart = upper_root(squared);
  Distance result{stretch * in_chart, {}};
  result.excess.most = std::min((of_double(result.chord) - square_root(squared)).upper(), excess(in_chart));
  return result;
}

ChordExcess ChordBend::excess(const Matrix<Interval>& chord) const {
  ChordExcess result;
  const Interval c = square_root(squared_norm(chord));
  if (!(c.lower() > 0 && room <= c.lower())) return result;
  const Matrix<Interval> change = second * chord;  // of Df along the chord
  const Interval bent = transposed_times(chord, change)[0];
  const Interval most = of_double(size_above(bent));  // A' c^2
  const double least = std::max({bent.lower(), -bent.upper(), 0.0});
  // The part of D^2 f u across u is not longer than D^2 f u less a multiple of u, any one.
  const Interval multiple = of_double(NearPoints::middle(bent / square(c)));
  Matrix<Interval> rest = second;
  for (std::size_t k = 0; k < rest.rows(); ++k) rest(k, k) = rest(k, k) - multiple;
  const Interval across = of_double(norm_above(rest * chord));  // beta c
  // The points at hand are within half the chord, and then within this, of the place.
  const Interval off = of_double(room) + of_double(beside);
  Matrix<Interval> normal = gradient;  // exactly, and about Df
  for (std::size_t k = 0; k < normal.size(); ++k) normal[k] = of_double(NearPoints::middle(normal[k]));
  const Interval length_of_normal = square_root(squared_norm(normal));
  const Interval rise = transposed_times(gradient, normal)[0] -
                        of_double(size_above(transposed_times(change, normal)[0])) / Interval(2) -
                        off * of_double(norm_above(second * normal));
  const Interval tilt = of_double(size_above(transposed_times(chord, normal)[0])) / c;
  const Interval along = (most / Interval(2) + across * of_double(room)) / c;  // |<Df, u>|
  const Interval gamma = (rise - tilt * along) / length_of_normal;
  const Interval spare = gamma - across / Interval(2);
  if (!(spare.lower() > 0 && (spare * of_double(room)).lower() >= (most / Interval(4)).upper())) return result;
  const Interval steepest =
      square_root(squared_norm(gradient) + of_double(size_above(transposed_times(change, gradient)[0])) +
                  squared_norm(change) / Interval(4)) +
      off * of_double(norm_above(second));
  const Interval above =
      of_double((most / (of_double(low_root) * c * (gamma - of_double(wirtinger) * across))).upper());
  const Interval longer = Interval(1) + square(above) / Interval(2);  // what is not longer, over c
  const Interval below =
      of_double(least) / (of_double(high_root) * c * (steepest + of_double(wirtinger) * across * longer));
  result.most = (c * square(above) / Interval(2)).upper();
  result.least = (c * square(of_double(std::max(below.lower(), 0.0))) / Interval(2)).lower();
  return result;
}

std::optional<ChordBend> bend_about_chords(const std::vector<std::array<Quantity, 2>>& box_of_M,
                                           FormulaValues<Interval>& values, const Matrix<Interval>& from,
                                           const Matrix<Interval>& to) {
  const std::size_t N = from.size();
  Matrix<Interval> part = from, place = from;
  for (std::size_t k = 0; k < N; ++k) {
    part[k] = Interval::between(std::min(from[k].lower(), to[k].lower()), std::max(from[k].upper(), to[k].upper()));
    place[k] = of_double(NearPoints::middle(part[k]));
  }
  values.evaluate(place, 2);
  ChordBend result;
  result.gradient = values.jacobian().transposed();
  const Interval longest_squared = of_double(squared_norm(to - from).upper());
  // Any room would do; this is half as much again as a curve along the chord needs where D^2 f hardly changes.
  result.room = (of_double(0.375) * longest_squared *
                 square_root(squared_norm(second_of(values, N)) / squared_norm(result.gradient)))
                    .upper();
  if (!(result.room > 0 && result.room < upper_root(longest_squared))) return {};
  for (std::size_t k = 0; k < N; ++k) {
    part[k] = part[k] + Interval::between(-result.room, result.room);
    if (!(part[k].lower() > box_of_M[k][0].filter.upper() && part[k].upper() < box_of_M[k][1].filter.lower()))
      return {};
  }
  values.evaluate(part, 2);
  result.second = second_of(values, N);
  result.beside = norm_above(of_double(0.5) * (from + to) - place);
  if (!(norm_above(result.second) < infinity && norm_above(result.gradient) < infinity)) return {};
  return result;
}

}  // namespace delcert::checker
