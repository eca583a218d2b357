#include "kernel/manifold/submanifold/chord_bend.hpp"

#include <algorithm>

#include "kernel/number/middle.hpp"
#include "kernel/number/scalar.hpp"

namespace delcert {

namespace {

/// 1/π, from above.
const Interval inverse_of_pi = Interval::exactly(0.31831);

Interval upper_end(const Interval& x) { return Interval::exactly(x.upper()); }

Interval squared_length(const Dense<Interval>& x) {
  Interval result(0);
  for (const Interval& entry : x) result += square(entry);
  return result;
}
Interval product(const Dense<Interval>& x, const Interval* y) {
  Interval result(0);
  for (std::size_t k = 0; k < x.size(); ++k) result += x[k] * y[k];
  return result;
}

}  // namespace

ChordExcess ChordBend::excess(const Interval* chord) const {
  const std::size_t n = gradient.size();
  const Interval h = Interval::exactly(room);
  Dense<Interval> normal(n);  // exactly, and about Df
  for (std::size_t k = 0; k < n; ++k) normal[k] = Interval::exactly(middle_of(gradient[k]));
  Interval squared(0);
  Dense<Interval> change(n);  // of Df along the chord
  Dense<Interval> tilted(n);  // D²f·n
  for (std::size_t k = 0; k < n; ++k) {
    squared += square(chord[k]);
    for (std::size_t l = 0; l < n; ++l) {
      change[k] += second[k * n + l] * chord[l];
      tilted[k] += second[k * n + l] * normal[l];
    }
  }
  const Interval c = square_root(squared);
  ChordExcess result;
  if (!is_proved(less(Interval(0), c)) || !is_proved(less_equal(h, c))) return result;
  const Interval bent = product(change, chord);  // c²·D²f[u, u]
  const Interval least = Interval::exactly(absolute(bent).lower());
  const Interval most = upper_end(absolute(bent));
  // c·β: what is orthogonal to u in D²f·u is no longer than D²f·u − λu, for any λ.
  const Interval multiple = Interval::exactly(middle_of(bent / squared));
  Interval across_squared(0);
  for (std::size_t k = 0; k < n; ++k) {
    Interval rest(0);
    for (std::size_t l = 0; l < n; ++l) rest += (k == l ? second[k * n + l] - multiple : second[k * n + l]) * chord[l];
    across_squared += square(rest);
  }
  const Interval across = upper_end(square_root(across_squared));
  // All points at hand are along half the chord and then within this of the place of the gradient.
  const Interval off = h + Interval::exactly(beside);
  const Interval tilt = absolute(product(normal, chord)) / c;
  const Interval rise = product(gradient, normal.data()) - absolute(product(change, normal.data())) / Interval(2) -
                        off * square_root(squared_length(tilted)) - tilt * (most / Interval(2) + across * h) / c;
  const Interval gamma = rise / square_root(squared_length(normal));
  const Interval spare = gamma - across / Interval(2);
  if (!is_proved(less(Interval(0), spare)) || !is_proved(less_equal(most / Interval(4), spare * h))) return result;
  const Interval steepest = square_root(squared_length(gradient) + absolute(product(change, gradient.data())) +
                                        squared_length(change) / Interval(4)) +
                            off * square_root(squared_length(second));
  const Interval scaled = c * square_root(Interval(12));
  const Interval above = upper_end(most / (scaled * (gamma - inverse_of_pi * across)));
  const Interval length = Interval(1) + square(above) / Interval(2);  // at most, over c
  const Interval below = least / (scaled * (steepest + inverse_of_pi * across * length));
  result.least = (c * square(below) / Interval(2)).lower();
  result.most = (c * square(above) / Interval(2)).upper();
  return result;
}

std::optional<ChordBend> bend_about_chords(const ZeroSet& zero_set, FormulaEvaluation<Interval>& f,
                                           const Interval* from, const Interval* to) {
  const std::size_t n = zero_set.ambient();
  if (zero_set.codimension() != 1) return std::nullopt;
  std::vector<Interval> part(n), place(n);
  Interval longest_squared(0);
  Interval beside_squared(0);
  for (std::size_t k = 0; k < n; ++k) {
    part[k] = Interval::between(std::min(from[k].lower(), to[k].lower()), std::max(from[k].upper(), to[k].upper()));
    place[k] = Interval::exactly(middle_of(part[k]));
    longest_squared += square(to[k] - from[k]);
    beside_squared += square((from[k] + to[k]) / Interval(2) - place[k]);
  }
  ChordBend result{Dense<Interval>(n), Dense<Interval>(n * n)};
  Interval value(0);
  if (!f.second(place.data(), &value, result.gradient.data(), result.second.data())) return std::nullopt;
  // Half as much again as curves along the chords need where D²f hardly changes; any room would do.
  const Interval bend = square_root(squared_length(result.second) / squared_length(result.gradient));
  result.room = (Interval::exactly(0.375) * longest_squared * bend).upper();
  if (!(result.room > 0 && result.room < square_root(longest_squared).upper())) return std::nullopt;
  for (std::size_t axis = 0; axis < n; ++axis) {
    part[axis] += Interval::between(-result.room, result.room);
    const auto& [low, high] = zero_set.box()[axis];
    if (!is_proved(less(scalar_from<Interval>(low), part[axis]))) return std::nullopt;
    if (!is_proved(less(part[axis], scalar_from<Interval>(high)))) return std::nullopt;
  }
  Dense<Interval> first(n);
  if (!f.second(part.data(), &value, first.data(), result.second.data())) return std::nullopt;
  result.beside = square_root(beside_squared).upper();
  return result;
}

}  // namespace delcert
