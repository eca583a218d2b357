#include "proofs/checker/charts/affine_charts.hpp"

namespace delcert::checker {

AffineCharts::AffineCharts(const Certificate& c) : StarCharts(c) {
  const std::size_t m = c.m_size();
  for (Label i = 0; i < c.n; ++i) {
    matrices_.push_back(upper_triangle(m, c.chart_entries(i)));
    inverses_.push_back(inverse_of_triangle(matrices_.back()));
    const SquareMatrix<Rational>& inverse = inverses_.back();
    SquareMatrix<Interval> filter(m);
    std::array<double, 4> stretch{};
    Vector<Rational> x = c.net.position<Rational>({i, {}});
    const Vector<Rational> home = c.points.position<Rational>({i, {}});
    for (std::size_t row = 0; row < m; ++row) {
      Rational squared(0);
      for (std::size_t k = row; k < m; ++k) {
        filter(row, k) = enclosure(matrices_.back()(row, k));
        squared = squared + square(inverse(row, k));
        x[row] = x[row] + inverse(row, k) * home[k];
      }
      stretch[row] = upper_root(enclosure(squared));
    }
    filters_.push_back(std::move(filter));
    stretches_.push_back(stretch);
    enclosed_.push_back({enclosure(x[0]), enclosure(x[1]), enclosure(x[2]), enclosure(x[3])});
    points_.push_back(std::move(x));
  }
}

SquareMatrix<Rational> upper_triangle(std::size_t m, const std::vector<Rational>& entries) {
  SquareMatrix<Rational> result(m);
  std::size_t next = 0;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = i; k < m; ++k) result(i, k) = entries[next++];
  }
  return result;
}

SquareMatrix<Rational> inverse_of_triangle(const SquareMatrix<Rational>& a) {
  const std::size_t m = a.order();
  SquareMatrix<Rational> result(m);
  for (std::size_t k = 0; k < m; ++k) {
    result(k, k) = Rational(1) / a(k, k);
    for (std::size_t i = k; i-- > 0;) {
      Rational sum(0);
      for (std::size_t j = i + 1; j <= k; ++j) sum = sum + a(i, j) * result(j, k);
      result(i, k) = -sum / a(i, i);
    }
  }
  return result;
}

}  // namespace delcert::checker
