#include "kernel/manifold/submanifold/tangent_chart.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr int skew_digits = 12;
constexpr int preconditioner_digits = 20;

/// 2(1 + A)⁻¹ − 1 = (1 − A)(1 + A)⁻¹, its columns in order: T. None if 1 + A is singular, to double precision.
template <class S>
std::optional<Dense<S>> cayley_frame(const std::vector<S>& skew, const std::vector<int>& columns) {
  const std::size_t n = columns.size();
  Dense<S> sum(n * n, S(0));
  std::size_t next = 0;
  for (std::size_t row = 0; row < n; ++row) {
    sum[row * n + row] = S(1);
    for (std::size_t column = row + 1; column < n; ++column, ++next) {
      sum[row * n + column] = skew[next];
      sum[column * n + row] = -skew[next];
    }
  }
  const auto inverse = inverse_of(std::move(sum), n);
  if (!inverse) return std::nullopt;
  Dense<S> result(n * n);
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto column = static_cast<std::size_t>(std::abs(columns[k]) - 1);
      const S entry = S(2) * (*inverse)[row * n + column] - (row == column ? S(1) : S(0));
      result[row * n + k] = columns[k] > 0 ? entry : -entry;
    }
  }
  return result;
}

/// (1 + (1 + P)^{1/2})⁻¹ for a positive semidefinite P.
Dense<double> half_slope(Dense<double> p, std::size_t n) {
  constexpr int steps = 24;
  for (std::size_t k = 0; k < n; ++k) p[k * n + k] += 1;
  Dense<double> root = p;
  for (int step = 0; step < steps; ++step) {
    const auto inverse = inverse_of(root, n);
    if (!inverse) break;
    for (std::size_t row = 0; row < n; ++row) {
      for (std::size_t column = 0; column < n; ++column) {
        double product = 0;
        for (std::size_t k = 0; k < n; ++k) product += (*inverse)[row * n + k] * p[k * n + column];
        root[row * n + column] = (root[row * n + column] + product) / 2;
      }
    }
  }
  for (std::size_t k = 0; k < n; ++k) root[k * n + k] += 1;
  return inverse_of(root, n).value_or(Dense<double>(n * n, 0));
}

template <class S>
EnclosedChart<S> enclosed_chart(const ChartData& data, std::size_t dimension, const Dense<Rational>& frame) {
  EnclosedChart<S> result;
  result.dimension = dimension;
  for (const Rational& x : data.centre) result.centre.push_back(scalar_from<S>(x));
  for (const Rational& x : frame) result.frame.push_back(scalar_from<S>(x));
  for (const Rational& x : data.preconditioner) result.preconditioner.push_back(scalar_from<S>(x));
  return result;
}

}  // namespace

TangentChart::TangentChart(ChartData data, std::size_t dimension) : data_(std::move(data)) {
  const std::size_t n = data_.centre.size();
  if (dimension < 1 || dimension >= n || data_.columns.size() != n || data_.skew.size() != n * (n - 1) / 2 ||
      data_.preconditioner.size() != (n - dimension) * (n - dimension))
    throw InputError("a chart has not as many numbers as it needs");
  std::vector<bool> is_used(n, false);
  for (const int column : data_.columns) {
    const auto axis = static_cast<std::size_t>(std::abs(column));
    if (axis < 1 || axis > n || is_used[axis - 1])
      throw InputError("the columns of a chart are no permutation with signs");
    is_used[axis - 1] = true;
  }
  const RoundingGuard guard;
  enclosed_ = enclosed_chart<Interval>(data_, dimension, frame());
}

void TangentChart::set_size(Rational radius, Rational height) {
  data_.radius = std::move(radius);
  data_.height = std::move(height);
}

Dense<Rational> TangentChart::frame() const {
  // 1 + A is invertible for every skew A.
  return cayley_frame<Rational>(data_.skew, data_.columns).value();
}

template <class S>
EnclosedChart<S> TangentChart::on() const {
  return enclosed_chart<S>(data_, dimension(), frame());
}
template EnclosedChart<BigInterval> TangentChart::on() const;
template EnclosedChart<Rational> TangentChart::on() const;

std::optional<ProposedFrame> propose_frame(const Dense<double>& derivative, std::size_t codimension,
                                           std::size_t ambient) {
  const std::size_t q = codimension;
  const std::size_t m = ambient - q;
  // Elimination with full pivots: the normal coordinates are those in which tangent vectors are flattest.
  Dense<double> a = derivative;
  std::vector<std::size_t> normal;
  std::vector<std::size_t> pivot_rows;
  double first_pivot = 0;
  for (std::size_t step = 0; step < q; ++step) {
    std::size_t row = q;
    std::size_t column = 0;
    double most = 0;
    for (std::size_t r = 0; r < q; ++r) {
      if (std::find(pivot_rows.begin(), pivot_rows.end(), r) != pivot_rows.end()) continue;
      for (std::size_t c = 0; c < ambient; ++c) {
        if (std::fabs(a[r * ambient + c]) > most) {
          most = std::fabs(a[r * ambient + c]);
          row = r;
          column = c;
        }
      }
    }
    if (step == 0) first_pivot = most;
    if (row == q || !(most > first_pivot * 0x1p-40)) return std::nullopt;
    const double scale = 1 / a[row * ambient + column];
    for (std::size_t c = 0; c < ambient; ++c) a[row * ambient + c] *= scale;
    for (std::size_t r = 0; r < q; ++r) {
      const double factor = a[r * ambient + column];
      if (r == row || factor == 0) continue;
      for (std::size_t c = 0; c < ambient; ++c) a[r * ambient + c] -= factor * a[row * ambient + c];
    }
    normal.push_back(column);
    pivot_rows.push_back(row);
  }
  std::vector<std::size_t> plane;
  for (std::size_t axis = 0; axis < ambient; ++axis) {
    if (std::find(normal.begin(), normal.end(), axis) == normal.end()) plane.push_back(axis);
  }
  // Tangent vectors are u on the plane, Bu on the normal axes.
  Dense<double> slope(q * m);
  for (std::size_t b = 0; b < q; ++b) {
    for (std::size_t k = 0; k < m; ++k) slope[b * m + k] = -a[pivot_rows[b] * ambient + plane[k]];
  }
  Dense<double> gram(m * m, 0);
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) {
      for (std::size_t b = 0; b < q; ++b) gram[row * m + column] += slope[b * m + row] * slope[b * m + column];
    }
  }
  const Dense<double> half = half_slope(std::move(gram), m);
  Dense<double> square(ambient * ambient, 0);
  for (std::size_t b = 0; b < q; ++b) {
    for (std::size_t k = 0; k < m; ++k) {
      double x = 0;
      for (std::size_t l = 0; l < m; ++l) x += slope[b * m + l] * half[l * m + k];
      x = std::ldexp(std::nearbyint(std::ldexp(x, skew_digits)), -skew_digits);
      square[plane[k] * ambient + normal[b]] = x;
      square[normal[b] * ambient + plane[k]] = -x;
    }
  }
  ProposedFrame result;
  for (const std::size_t axis : plane) result.columns.push_back(static_cast<int>(axis) + 1);
  for (const std::size_t axis : normal) result.columns.push_back(static_cast<int>(axis) + 1);
  for (std::size_t row = 0; row < ambient; ++row) {
    for (std::size_t column = row + 1; column < ambient; ++column)
      result.skew.push_back(square[row * ambient + column]);
  }
  result.frame = cayley_frame<double>(result.skew, result.columns).value();
  return result;
}

std::optional<TangentChart> tangent_chart(const Dense<double>& derivative, std::size_t codimension,
                                          const std::vector<Rational>& centre) {
  const std::size_t n = centre.size();
  const std::size_t q = codimension;
  const auto proposed = propose_frame(derivative, q, n);
  if (!proposed) return std::nullopt;
  ChartData data;
  data.centre = centre;
  data.columns = proposed->columns;
  for (const double entry : proposed->skew) data.skew.push_back(Rational::exactly(entry));
  Dense<double> normal(q * q, 0);
  for (std::size_t row = 0; row < q; ++row) {
    for (std::size_t column = 0; column < q; ++column) {
      for (std::size_t axis = 0; axis < n; ++axis)
        normal[row * q + column] += derivative[row * n + axis] * proposed->frame[axis * n + n - q + column];
    }
  }
  const auto inverse = inverse_of(std::move(normal), q);
  if (!inverse) return std::nullopt;
  double largest = 0;
  for (const double entry : *inverse) largest = std::max(largest, std::fabs(entry));
  const double step = std::ldexp(1.0, std::ilogb(largest) + 1 - preconditioner_digits);
  for (const double entry : *inverse)
    data.preconditioner.push_back(Rational::exactly(std::nearbyint(entry / step) * step));
  return TangentChart(std::move(data), n - q);
}

TangentChart tangent_chart(const ZeroSet& zero_set, FormulaEvaluation<double>& f, const std::vector<Rational>& centre) {
  std::vector<double> x;
  for (const Rational& coordinate : centre) x.push_back(approximate_double(coordinate));
  std::vector<double> value(zero_set.codimension());
  Dense<double> derivative(zero_set.codimension() * zero_set.ambient());
  const auto refuse = [&](const std::string& reason) {
    throw Rejection(zero_set.name() + ": " + reason + " at " + rough_text(x));
  };
  if (!f.first(x.data(), value.data(), derivative.data())) refuse("the equations are not defined");
  auto chart = tangent_chart(derivative, zero_set.codimension(), centre);
  if (!chart) refuse("the derivatives of the equations are not independent");
  return *std::move(chart);
}

std::string rough_text(const std::vector<double>& x) {
  std::string result = "(";
  for (std::size_t axis = 0; axis < x.size(); ++axis) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", x[axis]);
    result += (axis == 0 ? "" : ", ") + std::string(text);
  }
  return result + ")";
}

}  // namespace delcert
