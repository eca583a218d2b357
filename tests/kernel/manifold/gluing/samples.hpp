#pragma once

#include "kernel/manifold/gluing/metric_field_atlas.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {

using SquareOfRationals = MetricFieldDescription::Square;

/// f times the identity of order m.
inline SquareOfRationals multiple_of_identity(std::size_t m, const Rational& f) {
  SquareOfRationals result(m, std::vector<Rational>(m));
  for (std::size_t axis = 0; axis < m; ++axis) result[axis][axis] = f;
  return result;
}

inline SquareOfRationals zero_matrix(std::size_t m) { return multiple_of_identity(m, Rational(0)); }

/// (1 + height·cos 2πx₀)·I.
inline MetricFieldDescription hills(int m, const Rational& height) {
  const auto size = static_cast<std::size_t>(m);
  std::vector<int> frequency(size);
  frequency[0] = 1;
  return {"hills",
          Dimension(m),
          multiple_of_identity(size, Rational(1)),
          {{frequency, multiple_of_identity(size, height), zero_matrix(size)}}};
}

/// A constant metric.
inline MetricFieldDescription constant_field(SquareOfRationals gram) {
  const Dimension dimension(gram.size());
  return {"constant", dimension, std::move(gram), {}};
}

/// Rows of a sheared plane metric: diag(1, 2) with angles that vary along the first axis.
inline MetricFieldDescription shear() {
  return {"shear",
          Dimension(2),
          {{Rational(1), Rational(0)}, {Rational(0), Rational(2)}},
          {{{1, 0}, zero_matrix(2), {{Rational(0), ratio(1, 10)}, {ratio(1, 10), ratio(1, 10)}}},
           {{1, -1}, {{ratio(1, 20), Rational(0)}, {Rational(0), Rational(0)}}, zero_matrix(2)}}};
}

/// The multiples of 1/n in every coordinate.
template <int m>
std::vector<Vector<Rational, m>> lattice_points(long n) {
  std::vector<Vector<Rational, m>> result;
  Vector<long, m> at{};
  while (true) {
    Vector<Rational, m> point;
    for (std::size_t axis = 0; axis < m; ++axis) point[axis] = ratio(at[axis], n);
    result.push_back(point);
    std::size_t axis = 0;
    while (axis < m && ++at[axis] == n) at[axis++] = 0;
    if (axis == m) return result;
  }
}

/// Whether the enclosure holds the number.
inline bool holds(const Interval& x, const Rational& exact) {
  return Rational::exactly(x.lower()) <= exact && exact <= Rational::exactly(x.upper());
}

}  // namespace delcert::test
