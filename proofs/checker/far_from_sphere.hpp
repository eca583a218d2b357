#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "proofs/checker/metric.hpp"

namespace delcert::checker {

/// Tells of most points of a list, in doubles with a bound of their error, that their power s - <y, c> with respect to
/// a sphere is not small (docs/levels/3-forbidden-configurations.md, In doubles). Here c is the centre, s the squared
/// length of a point and y twice its covector. Precondition: the thread rounds upwards.
class FarFromSphere {
 public:
  explicit FarFromSphere(std::size_t m) : m_(m) {}

  void clear() { *this = FarFromSphere(m_); }
  void add(const Vector<Interval>& twice_covector, const Interval& squared_length) {
    std::array<double, 5>& point = points_.emplace_back();
    double sum = 0;
    for (std::size_t k = 0; k < m_; ++k) {
      point[k] = middle(twice_covector[k]);
      covector_error_ = larger(covector_error_, error(twice_covector[k], point[k]));
      sum += std::fabs(point[k]);
    }
    point[4] = middle(squared_length);
    length_error_ = larger(length_error_, error(squared_length, point[4]));
    longest_covector_ = larger(longest_covector_, sum);
    longest_ = larger(longest_, std::fabs(point[4]));
  }

  /// A sphere, and the absolute value of computed powers above which the power itself is more than `small`.
  struct Sphere {
    std::array<double, 4> centre{};
    double threshold = 0;
  };
  Sphere sphere(const Vector<Interval>& centre, double small) const {
    Sphere result;
    double greatest = 0, centre_error = 0;
    for (std::size_t k = 0; k < m_; ++k) {
      result.centre[k] = middle(centre[k]);
      greatest = larger(greatest, std::fabs(result.centre[k]));
      centre_error = larger(centre_error, error(centre[k], result.centre[k]));
    }
    const double enclosed = longest_covector_ * centre_error +
                            static_cast<double>(m_) * covector_error_ * (greatest + centre_error) + length_error_;
    const double rounded = 0x1p-49 * (longest_ + longest_covector_ * greatest) + 0x1p-1000;
    result.threshold = small + enclosed + rounded;
    return result;
  }
  /// The computed power of the point with this number.
  double power(const Sphere& sphere, std::size_t number) const {
    return points_[number][4] - product(sphere.centre, number);
  }
  /// Certainly |s - <y, c>| > small for the point with this number.
  bool is_far(const Sphere& sphere, std::size_t number) const {
    const double found = power(sphere, number);
    return found > sphere.threshold || -found > sphere.threshold;
  }
  /// Certainly s - <y, c> > bound, for a sphere with small = 0.
  bool is_above(const Sphere& sphere, std::size_t number, double bound) const {
    return power(sphere, number) > bound + sphere.threshold;
  }

 private:
  friend class SpherePencil;
  double product(const std::array<double, 4>& vector, std::size_t number) const {
    const std::array<double, 5>& point = points_[number];
    double sum = point[0] * vector[0];
    for (std::size_t k = 1; k < m_; ++k) sum += point[k] * vector[k];
    return sum;
  }
  /// A double in the interval or near it; NaN if it is not bounded, and then nothing is far.
  static double middle(const Interval& x) { return x.lower() + (x.upper() - x.lower()) / 2; }
  static double error(const Interval& x, double at) { return larger(x.upper() - at, at - x.lower()); }
  /// NaN if one of them is.
  static double larger(double a, double b) { return a > b || std::isnan(a) ? a : b; }

  std::size_t m_;
  std::vector<std::array<double, 5>> points_;
  double covector_error_ = 0, length_error_ = 0;  // of an entry; of s
  double longest_covector_ = 0, longest_ = 0;     // sum of the absolute values of the entries; |s|
};

/// The same for spheres with centres c + t n: the power of a point is P - t h, where P is its power for t = 0 and
/// h = <y, n>. Precondition: the thread rounds upwards.
class SpherePencil {
 public:
  /// n is perpendicular to a simplex with circumcentre c, |n|^2 = normal_squared.
  void open(const FarFromSphere& points, const Vector<Interval>& centre, const Interval& radius_squared,
            const Vector<Interval>& normal, const Interval& normal_squared) {
    points_ = &points;
    centre_ = points.sphere(centre, 0);
    normal_ = points.sphere(normal, 0);
    radius_squared_ = radius_squared;
    normal_squared_ = normal_squared;
    greatest_power_ = greatest_height_ = 0;
    powers_.resize(points.points_.size());
    heights_.resize(points.points_.size());
  }
  /// Before the point with this number is asked for.
  void add(std::size_t number) {
    powers_[number] = points_->power(centre_, number);
    heights_[number] = points_->product(normal_.centre, number);
    greatest_power_ = FarFromSphere::larger(greatest_power_, std::fabs(powers_[number]));
    greatest_height_ = FarFromSphere::larger(greatest_height_, std::fabs(heights_[number]));
  }

  /// The sphere that contains the point with a number, too.
  struct Sphere {
    double t = 0, least_radius_squared = 0, threshold = 0;
  };
  /// With the threshold for `factor` times the squared radius.
  Sphere through(std::size_t number, double factor) const {
    Sphere unknown, result;
    unknown.threshold = std::numeric_limits<double>::infinity();
    const double height = std::fabs(heights_[number]), least_height = -(normal_.threshold - height);
    if (!(least_height > 0)) return unknown;
    result.t = powers_[number] / heights_[number];
    const double size = std::fabs(result.t) * (1 + 0x1p-50),
                 error = (centre_.threshold + size * normal_.threshold) / least_height + size * 0x1p-50 + 0x1p-1000,
                 least = std::fmax(-(error - std::fabs(result.t)), 0), most = size + error;
    if (!(most < std::numeric_limits<double>::infinity())) return unknown;
    result.least_radius_squared = (radius_squared_ + square(Interval::between(least, most)) * normal_squared_).lower();
    const double small = factor * (radius_squared_.upper() + most * most * normal_squared_.upper());
    result.threshold = small + centre_.threshold + greatest_height_ * error + most * normal_.threshold +
                       0x1p-50 * (greatest_power_ + size * greatest_height_) + 0x1p-1000;
    return result;
  }
  bool is_far(const Sphere& sphere, std::size_t number) const {
    const double found = powers_[number] - sphere.t * heights_[number];
    return found > sphere.threshold || -found > sphere.threshold;
  }

 private:
  const FarFromSphere* points_ = nullptr;
  FarFromSphere::Sphere centre_, normal_;
  Interval radius_squared_{0}, normal_squared_{0};
  std::vector<double> powers_, heights_;
  double greatest_power_ = 0, greatest_height_ = 0;
};

}  // namespace delcert::checker
