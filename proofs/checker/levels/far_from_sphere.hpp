#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "proofs/checker/geometry/point_set.hpp"

namespace delcert::checker {

// Powers of points with respect to the circumspheres of simplices that have a vertex in common, in doubles with a bound
// of their errors (docs/levels/3-forbidden-configurations.md, In doubles). The thread rounds upwards.

/// Points near a vertex, seen from it: the squared distances from it, and the products of the vectors to them.
class SeenFromVertex {
 public:
  explicit SeenFromVertex(const PointSet& points)
      : set_(&points), m_(static_cast<std::size_t>(points.metric().dimension())) {
    const Metric& metric = points.metric();
    std::array<double, 4> sums{}, errors{};
    for (std::size_t k = 0; k < m_; ++k) {
      Vector<Interval> unit{};
      unit[k] = Interval(1);
      const Vector<Interval> column = metric.covector(unit);
      for (std::size_t i = 0; i < m_; ++i) {
        gram_[i][k] = middle(column[i]);
        sums[i] += std::fabs(gram_[i][k]);
        errors[i] += error_of(column[i]);
      }
      stretch_ = std::max(stretch_, metric.stretch(k));
    }
    row_ = *std::max_element(sums.begin(), sums.end());
    row_error_ = *std::max_element(errors.begin(), errors.end());
    middles_.resize(points.size());
    for (Label i = 0; i < points.size(); ++i) {
      const Vector<Interval> position = points.position<Interval>({i, {}});
      for (std::size_t k = 0; k < 4; ++k) {
        middles_[i][k] = middle(position[k]);
        position_error_ = std::max(position_error_, error_of(position[k]));
      }
    }
  }

  /// From here on from this one. There are no points yet; those farther than `longest_squared` do not count.
  void open(const Vertex& vertex, double longest_squared) {
    points_.clear();
    longest_squared_ = longest_squared;
    origin_ = middle(vertex);
    double farthest = 0;
    for (const double x : origin_) farthest = std::max(farthest, std::fabs(x));
    greatest_ = std::sqrt(longest_squared) * stretch_ * (1 + 0x1p-10);
    const double error = 2 * position_error_ + 0x1p-48 * (farthest + greatest_);
    const double bound = static_cast<double>(m_) * (2 * (row_ + row_error_) * (greatest_ + error) * error +
                                                    (row_error_ + 0x1p-48 * row_) * greatest_ * greatest_) +
                         0x1p-400;
    error_ = error < 0x1p-11 * greatest_ && bound < 0x1p900 ? bound : infinity;
  }
  /// Nothing is done if the point is certainly farther.
  void add(const Vertex& q) {
    Point point{q, middle(q), {}, 0};
    for (std::size_t k = 0; k < m_; ++k) {
      point.x[k] -= origin_[k];
      if (std::fabs(point.x[k]) > greatest_ && error_ < infinity) return;
    }
    for (std::size_t k = 0; k < m_; ++k) point.covector[k] = product(gram_[k], point.x);
    point.power = product(point.x, point.covector);
    if (!is_too_long(point.power)) points_.push_back(point);
  }
  /// After the last one: sorts them by their vertices.
  void close() {
    std::sort(points_.begin(), points_.end(), [](const Point& a, const Point& b) { return a.vertex < b.vertex; });
    products_.resize(size() * size());
    powers_.clear();
    for (std::size_t i = 0; i < size(); ++i) {
      powers_.push_back(points_[i].power);
      for (std::size_t k = i; k < size(); ++k) products_[i * size() + k] = product(points_[i].x, points_[k].covector);
    }
  }

  std::size_t size() const { return points_.size(); }
  std::size_t number(std::size_t i) const { return i; }
  const Vertex& vertex(std::size_t i) const { return points_[i].vertex; }
  /// Precondition of what follows: they are closed, and i <= k.
  double power(std::size_t i) const { return powers_[i]; }
  const double* powers() const { return powers_.data(); }
  double product(std::size_t i, std::size_t k) const { return products_[i * size() + k]; }
  const double* row(std::size_t i) const { return &products_[i * size()]; }
  /// No power and no product is wrong by more.
  double error() const { return error_; }
  double least_radius_squared() const { return 0; }
  double greatest_radius_squared() const { return 0; }
  /// Whether two of the points, i <= k, are certainly farther apart than one may be from the vertex.
  bool are_apart(std::size_t i, std::size_t k) const { return is_too_long(power(i) + power(k) - 2 * product(i, k)); }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  using Row = std::array<double, 4>;
  struct Point {
    Vertex vertex;
    Row x, covector;
    double power;
  };
  static double product(const Row& x, const Row& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3]; }
  bool is_too_long(double squared) const { return squared > longest_squared_ + 8 * error_; }
  Row middle(const Vertex& q) const {
    Row x = middles_[q.label];
    for (std::size_t k = 0; k < 4; ++k) x[k] += q.lift[k];
    return x;
  }
  /// A double in the interval or near it.
  static double middle(const Interval& x) { return x.lower() + (x.upper() - x.lower()) / 2; }
  /// Of that as the number that is enclosed.
  static double error_of(const Interval& x) {
    const double error = std::max(x.upper() - middle(x), middle(x) - x.lower());
    return error < infinity ? error : infinity;  // NaN if the interval is not bounded
  }

  const PointSet* set_;
  std::size_t m_;
  std::array<Row, 4> gram_{};
  double row_ = 0, row_error_ = 0;  // of |gram|, and of its errors: the greatest sum of a row
  std::vector<Row> middles_;        // of the labels, at lift 0
  double position_error_ = 0;       // of a coordinate of them
  double stretch_ = 0;
  Row origin_{};
  double greatest_ = 0;  // no coordinate of a point that counts is greater
  double longest_squared_ = 0, error_ = 0;
  std::vector<Point> points_;
  std::vector<double> powers_, products_;
};

/// How powers and products change when a point is added to the simplex from which they are seen. Products of it are
/// those with points at later places.
template <class Seen>
class AddedVertex {
 public:
  AddedVertex(const Seen& seen, std::size_t at) : powers_(seen.powers()), row_(seen.row(at)) {
    const double power = powers_[at], size = row_[at], error = seen.error();
    const double least = std::fabs(power) > 2 * error ? -(error - std::fabs(power)) : 0,
                 most = std::fabs(power) + error;
    inverse_ = 1 / size;
    slope_ = power * inverse_;
    // If infinite, nothing is far.
    error_ = size > 0x1p20 * error ? error : std::numeric_limits<double>::infinity();
    least_radius_squared_ = (seen.least_radius_squared() + least * least / (4 * (size + error))) * (1 - 0x1p-49);
    greatest_radius_squared_ = seen.greatest_radius_squared() + 0.2501 * most * most * inverse_;
  }

  /// Of the larger simplex; the least one can be infinite, if that is degenerate.
  double least_radius_squared() const { return least_radius_squared_; }
  double greatest_radius_squared() const { return greatest_radius_squared_; }
  double row(std::size_t k) const { return row_[k]; }
  double power(std::size_t k) const { return powers_[k] - slope_ * row_[k]; }
  /// The product of two points, from that before and their entries in the row.
  double reduced(double product, double row_i, double row_k) const { return product - row_i * inverse_ * row_k; }
  double steepness(double row) const { return std::max(std::fabs(slope_), std::fabs(row) * inverse_); }
  /// What is computed from rows of at most this steepness is wrong by no more.
  double error(double steepness) const {
    const double bound = 2 * (1 + steepness) * (1 + steepness) * error_;
    return bound < 0x1p900 ? bound : std::numeric_limits<double>::infinity();
  }
  /// Whether the power of the point at this place certainly has more than this absolute value.
  bool is_far(std::size_t k, double small) const { return std::fabs(power(k)) > small + error(steepness(row(k))); }

 private:
  const double *powers_, *row_;
  double inverse_, slope_, error_, least_radius_squared_, greatest_radius_squared_;
};

/// Some of these points seen from a simplex with that vertex: their powers with respect to the sphere about its
/// circumcentre, and the products of their parts perpendicular to it.
class SeenFromSimplex {
 public:
  /// From here on of these points, of which there are so many, each at a place in what is seen before:
  /// is_seen(k) for the places k after `at`.
  template <class IsSeen>
  void choose(std::size_t at, std::size_t end, const IsSeen& is_seen) {
    if (places_.size() < end) places_.resize(end);
    std::size_t size = 0, *const places = places_.data();
    for (std::size_t k = at + 1; k < end; ++k) {
      places[size] = k;
      size += is_seen(k);  // without a branch, which nothing could foresee
    }
    size_ = size;
  }

  /// Finds the powers of these points. The vertex is at `at`.
  template <class Seen>
  void see(const Seen& before, const AddedVertex<Seen>& vertex) {
    if (powers_.size() < size_) {
      for (std::vector<double>* of : {&powers_, &row_}) of->resize(size_);
      numbers_.resize(size_);
    }
    double longest = 0, least = std::numeric_limits<double>::infinity();
    const std::size_t* const places = places_.data();
    for (std::size_t k = 0, size = size_; k < size; ++k) {
      const double power = vertex.power(places[k]), row = vertex.row(places[k]);
      numbers_[k] = before.number(places[k]);
      powers_[k] = power;
      row_[k] = row;
      least = std::min(least, std::fabs(power));
      longest = std::max(longest, std::fabs(row));
    }
    error_ = vertex.error(vertex.steepness(longest));
    least_power_ = least;
    least_radius_squared_ = vertex.least_radius_squared();
    greatest_radius_squared_ = vertex.greatest_radius_squared();
  }
  /// Finds their products. Precondition: the powers are those of this vertex.
  template <class Seen>
  void multiply(const Seen& before, const AddedVertex<Seen>& vertex) {
    if (products_.size() < size_ * size_) products_.resize(size_ * size_);
    for (std::size_t i = 0, size = size_; i < size; ++i) {
      const double* const of_i = before.row(places_[i]);
      double* const products = &products_[i * size];
      const double row_i = row_[i];
      for (std::size_t k = i; k < size; ++k) products[k] = vertex.reduced(of_i[places_[k]], row_i, row_[k]);
    }
  }

  std::size_t size() const { return size_; }
  std::size_t place(std::size_t i) const { return places_[i]; }
  std::size_t number(std::size_t i) const { return numbers_[i]; }
  double power(std::size_t i) const { return powers_[i]; }
  const double* powers() const { return powers_.data(); }
  /// Precondition: i <= k.
  double product(std::size_t i, std::size_t k) const { return products_[i * size_ + k]; }
  const double* row(std::size_t i) const { return &products_[i * size_]; }
  /// No power and no product is wrong by more.
  double error() const { return error_; }
  double least_radius_squared() const { return least_radius_squared_; }
  double greatest_radius_squared() const { return greatest_radius_squared_; }
  /// Whether all powers certainly have more than this absolute value.
  bool are_far(double small) const { return least_power_ > small + error_; }

 private:
  std::size_t size_ = 0;
  std::vector<std::size_t> places_, numbers_;  // in what is seen before; in what the vertex sees
  std::vector<double> powers_, row_, products_;
  double error_ = 0, least_power_ = 0, least_radius_squared_ = 0, greatest_radius_squared_ = 0;
};

}  // namespace delcert::checker
