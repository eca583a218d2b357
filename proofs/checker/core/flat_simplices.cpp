#include "proofs/checker/core/flat_simplices.hpp"

#include <cmath>

#include "proofs/checker/parts/chunk_items.hpp"

namespace delcert::checker::core {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double width(const Interval& x) { return x.upper() - x.lower(); }

}  // namespace

FlatSimplices::FlatSimplices(Complex& complex)
    : complex_(complex), form_(complex.data), found_(complex.data.simplices()) {
  const std::size_t m = complex.data.m;
  std::array<std::array<double, 3>, 3> gram{};
  double row = 0, row_error = 0;  // of |gram|, and of its errors: the greatest sum of a row
  for (std::size_t i = 0; i < m; ++i) {
    double sum = 0, error = 0;
    for (std::size_t k = 0; k < m; ++k) {
      gram[i][k] = form_.gram()(i, k).upper();
      sum += std::fabs(gram[i][k]);
      error += width(form_.gram()(i, k));
    }
    row = std::max(row, sum);
    row_error = std::max(row_error, error);
  }
  rows_.reserve(complex.neighbours.items.size());
  reach_.resize(complex.size());
  for (Label i = 0; i < complex.size(); ++i) {
    const Vector<Interval> base = complex.point<Interval>(i);
    double reach = 0;
    for (std::size_t at = 0; at < complex.neighbours.size(i); ++at) {
      const Neighbour& neighbour = complex.neighbours.of(i)[at];
      const Vector<Interval> q = complex.elements.moved(neighbour.phi, complex.point<Interval>(neighbour.label));
      Row y{};
      for (std::size_t k = 0; k < m; ++k) {
        y.x[k] = q[k].upper() - base[k].upper();
        reach = std::max(reach, std::fabs(y.x[k]));
        width_ = std::max(width_, std::max(width(q[k]), width(base[k])));
      }
      double square = 0;
      for (std::size_t k = 0; k < m; ++k)
        square += y.x[k] * (gram[k][0] * y.x[0] + gram[k][1] * y.x[1] + gram[k][2] * y.x[2]);
      y.half_square = square / 2;
      rows_.push_back(y);
    }
    reach_[i].reach = reach;
  }
  for (Reach& of : reach_) {
    const double reach = of.reach, error = width_ + 0x1p-51 * reach;
    of.error = static_cast<double>(m) *
                   ((row + row_error) * (reach + error) * error + (row_error + 0x1p-49 * row) * reach * reach) +
               0x1p-1000;
  }
}

/// Of the neighbours of a vertex with this label that are no vertices of the simplex; minus infinity if it is not known
/// which these are. `linear` is the form x -> <x, C - v> for this vertex v.
double FlatSimplices::least_power(Label i, const Vector<Interval>& linear) const {
  std::array<double, 3> form{};
  double sum = 0, form_error = 0;
  for (std::size_t k = 0; k < complex_.data.m; ++k) {
    form[k] = linear[k].upper();
    sum += std::fabs(form[k]);
    form_error = std::max(form_error, width(linear[k]));
  }
  const double reach = reach_[i].reach, error = width_ + 0x1p-51 * reach;
  const double bound =
      sum * error + 4 * form_error * (reach + error) + 0x1p-49 * sum * reach + reach_[i].error;  // of a power
  if (!(bound < infinity)) return -infinity;
  require_star(i);
  // The m vertices of the simplex among the neighbours have the power 0, which is not above the bound; if nothing else
  // is not above it, they are left out without a search for them.
  double least = infinity;
  std::size_t others = 0;
  const Row* const end = rows_.data() + complex_.neighbours.begin[i + 1];
  for (const Row* y = rows_.data() + complex_.neighbours.begin[i]; y != end; ++y) {
    const double power = y->half_square - (form[0] * y->x[0] + form[1] * y->x[1] + form[2] * y->x[2]);
    const bool is_above = power > bound;
    least = std::min(least, is_above ? power : infinity);
    others += is_above ? 1 : 0;
  }
  return others + complex_.data.m == complex_.neighbours.size(i) ? -(bound - least) : -infinity;
}

FlatSimplex FlatSimplices::look_at(std::uint32_t s) {
  const std::size_t m = complex_.data.m;
  const Lifts<Interval> lifts = complex_.lifts<Interval>(s);
  const Frame<Interval> frame(0, m, lifts, 0);
  Vector<Interval> linear{}, sum{};  // the form x -> <x, C - v_0>; of cofactors
  Interval determinant(0), longest(0), inverse_altitude(0);
  for (std::size_t k = 1; k <= m; ++k) {
    const Vector<Interval> cofactors = frame.cofactors_of(k);
    const Vector<Interval>& edge = frame.columns[frame.place(k)];
    if (k == 1) determinant = dot(cofactors, edge, m);
    const Interval squared = form_.squared(edge);
    longest = maximum(longest, squared);
    for (std::size_t other = 1; other < k; ++other)
      longest = maximum(longest, form_.squared(edge - frame.columns[frame.place(other)]));
    linear = add(linear, squared, cofactors);
    sum = add(sum, Interval(1), cofactors);
    inverse_altitude = maximum(inverse_altitude, form_.squared_covector(cofactors));
  }
  const Interval inverse = Interval(1) / (Interval(2) * determinant);
  for (std::size_t k = 0; k < m; ++k) linear[k] = linear[k] * inverse;
  const Interval radius = form_.squared_covector(linear);
  double power = least_power(complex_.label(s, 0), linear);
  for (std::size_t k = 1; k <= m; ++k)
    power = std::min(power, least_power(complex_.label(s, k), linear - form_.covector(frame.columns[frame.place(k)])));
  FlatSimplex found;
  found.power = power;
  found.radius = radius.upper();
  if (std::fabs(power) < infinity) found.nearest = (radius + Interval(2) * Interval::between(power, power)).lower();
  found.altitude = (square(determinant) / maximum(inverse_altitude, form_.squared_covector(sum))).lower();
  found.longest = longest.upper();
  return found;
}

}  // namespace delcert::checker::core
