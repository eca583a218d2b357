#pragma once

#include <cmath>

#include "proofs/checker/core/around_simplex.hpp"
#include "proofs/checker/core/circumball.hpp"

namespace delcert::checker::core {

/// The powers of the points around a simplex with respect to its circumball, in doubles with a bound of their errors
/// (docs/levels/core.md, Powers in doubles). Precondition: the thread rounds upwards.
class PowersAround {
 public:
  /// Keeps a reference. Precondition: core.edges holds.
  explicit PowersAround(Complex& complex) : complex_(complex), around_(complex), m_(complex.data.m) {
    if (complex.data.K != 0) return;
    const Form<Interval> form(complex.data);
    for (std::size_t i = 0; i < m_; ++i) {
      double sum = 0, error = 0;
      for (std::size_t k = 0; k < m_; ++k) {
        const Interval& entry = form.gram()(i, k);
        gram_[i][k] = entry.upper();
        sum += std::fabs(entry.upper());
        error += width(entry);
      }
      row_ = std::max(row_, sum);
      row_error_ = std::max(row_error_, error);
    }
  }

  struct Point {
    Label label;
    Elements::Id element;
    double power;
  };
  /// Finds the points and powers of this simplex.
  void look(std::uint32_t s, const Circumball<Interval>& ball) {
    points_.clear();
    double linear_sum = 0, linear_error = 0;
    reach_ = width_ = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      base_[k] = ball.base()[k].upper();
      linear_[k] = ball.linear()[k].upper();
      width_ = std::max(width_, width(ball.base()[k]));
      linear_error = std::max(linear_error, width(ball.linear()[k]));
      linear_sum += std::fabs(linear_[k]);
    }
    around_.visit(s, [&](Label j, Elements::Id moved) {
      points_.push_back({j, moved, power(complex_.elements.moved(moved, complex_.point<Interval>(j)))});
    });
    const double m = static_cast<double>(m_), error = width_ + 0x1p-51 * reach_;
    error_ = linear_sum * error + 4 * linear_error * (reach_ + error) + 0x1p-49 * linear_sum * reach_ +
             m * ((row_ + row_error_) * (reach_ + error) * error + (row_error_ + 0x1p-49 * row_) * reach_ * reach_) +
             0x1p-1000;
  }
  const std::vector<Point>& points() const { return points_; }
  /// No power is wrong by more. NaN or infinite if something is not bounded.
  double error() const { return error_; }
  /// Whether the point certainly has a greater power than this.
  bool is_above(const Point& point, double bound) const { return point.power > bound + error_; }
  /// A lower bound of all powers, which intervals give: of those points only of which it is not known that others have
  /// less. Infinity if there is no point.
  double least(const Circumball<Interval>& ball) {
    double least = std::numeric_limits<double>::infinity(), result = least;
    for (const Point& point : points_) least = std::min(least, point.power);
    for (const Point& point : points_) {
      if (is_above(point, least + error_)) continue;
      const Vector<Interval> q = complex_.elements.moved(point.element, complex_.point<Interval>(point.label));
      result = std::min(result, ball.power(q).lower());
    }
    return result;
  }

 private:
  using Row = std::array<double, 4>;
  /// Rounded upwards; NaN or infinite if the interval is not bounded.
  static double width(const Interval& x) { return x.upper() - x.lower(); }
  static double product(const Row& x, const Row& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3]; }
  double power(const Vector<Interval>& q) {
    Row y{};
    for (std::size_t k = 0; k < 4; ++k) {
      y[k] = q[k].upper() - base_[k];
      reach_ = std::max(reach_, std::fabs(y[k]));
      width_ = std::max(width_, width(q[k]));
    }
    const double along = product(linear_, y);
    if (complex_.data.K != 0) return complex_.data.K > 0 ? -along : along;
    return (y[0] * product(gram_[0], y) + y[1] * product(gram_[1], y) + y[2] * product(gram_[2], y) +
            y[3] * product(gram_[3], y)) /
               2 -
           along;
  }

  Complex& complex_;
  AroundSimplex around_;
  std::size_t m_;
  std::array<Row, 4> gram_{};
  double row_ = 0, row_error_ = 0;  // of |gram|, and of its errors: the greatest sum of a row
  Row base_{}, linear_{};
  double reach_ = 0, width_ = 0;  // greatest coordinate of a point from the base; width of an enclosure of one
  double error_ = 0;
  std::vector<Point> points_;
};

}  // namespace delcert::checker::core
