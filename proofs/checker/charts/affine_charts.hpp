#pragma once

#include <array>
#include <vector>

#include "proofs/checker/charts/chart_stars.hpp"

namespace delcert::checker {

/// Affine charts x -> A_i (x - p_i) of pieces of R^m, of metric fields and of atlases by formulas.
class AffineCharts : public StarCharts<Rational> {
 public:
  explicit AffineCharts(const Certificate& c);

  const SquareMatrix<Rational>& matrix(Label i) const { return matrices_[i]; }
  const SquareMatrix<Interval>& enclosed_matrix(Label i) const { return filters_[i]; }
  const SquareMatrix<Rational>& inverse(Label i) const { return inverses_[i]; }
  /// An upper bound of sqrt((B_i^-1)_kk), for every axis k: |x_k| <= stretch |A_i x|.
  const std::array<double, 4>& stretch(Label i) const { return stretches_[i]; }
  /// p_i + A_i^-1 y_i: the perturbed point in R^m.
  template <class N>
  const Vector<N>& point(Label j) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return enclosed_[j];
    } else {
      return points_[j];
    }
  }
  /// A_i (x - p_i).
  template <class N>
  Vector<N> in_chart(Label i, const Vector<N>& x) const {
    const Vector<N> centre = c_.net.position<N>({i, {}});
    Vector<N> result{};
    for (std::size_t row = 0; row < c_.m_size(); ++row) {
      N sum(0);
      for (std::size_t k = row; k < c_.m_size(); ++k) {
        if constexpr (std::is_same_v<N, Interval>) {
          sum = sum + filters_[i](row, k) * (x[k] - centre[k]);
        } else {
          sum = sum + matrices_[i](row, k) * (x[k] - centre[k]);
        }
      }
      result[row] = sum;
    }
    return result;
  }

  Vector<Interval> home(Label i, In<Interval>) const override { return c_.points.position<Interval>({i, {}}); }
  Vector<Rational> home(Label i, In<Rational>) const override { return c_.points.position<Rational>({i, {}}); }

 protected:
  const std::vector<Vector<Interval>>& enclosed_points() const { return enclosed_; }

 private:
  std::vector<SquareMatrix<Rational>> matrices_, inverses_;
  std::vector<SquareMatrix<Interval>> filters_;
  std::vector<std::array<double, 4>> stretches_;
  std::vector<Vector<Rational>> points_;
  std::vector<Vector<Interval>> enclosed_;
};

/// The matrix with these entries on and above the diagonal, row by row.
SquareMatrix<Rational> upper_triangle(std::size_t m, const std::vector<Rational>& entries);
/// The inverse of an upper triangular matrix without zeros on its diagonal.
SquareMatrix<Rational> inverse_of_triangle(const SquareMatrix<Rational>& a);

}  // namespace delcert::checker
