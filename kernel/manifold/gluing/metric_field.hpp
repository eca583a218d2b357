#pragma once

#include <string>
#include <vector>

#include "kernel/manifold/gluing/periodic_waves.hpp"
#include "kernel/number/strong.hpp"
#include "kernel/simplex/frame_metric.hpp"

namespace delcert {

/// A trigonometric polynomial of symmetric matrices as a file describes it (docs/metric-fields.md).
struct MetricFieldDescription {
  using Square = std::vector<std::vector<Rational>>;
  struct Term {
    std::vector<int> frequency;
    Square cosine;
    Square sine;
  };
  std::string name;
  Dimension dimension{2};  ///< 2 or 3
  Square constant;
  std::vector<Term> waves;
};

/// Positive numbers between which all eigenvalues of a metric field are.
struct EigenvalueBounds {
  Rational lower;
  Rational upper;
};

/// A simple sampling radius for which patches of the least size fit on any net (field.patch of docs/metric-fields.md).
[[nodiscard]] Rational fitting_sampling_radius(const EigenvalueBounds& bounds);

/// A Riemannian metric on ℝᵐ/ℤᵐ: G(x) = constant + Σ cosine·cos(2π k·x) + sine·sin(2π k·x), a symmetric matrix for
/// every x, periodic by its form.
template <int m>
class MetricField {
 public:
  /// Throws InputError unless m is its dimension and its matrices are symmetric of that size; Rejection unless G is
  /// certainly positive definite everywhere: by enclosures on boxes, at most 2¹⁸ of them.
  explicit MetricField(MetricFieldDescription description);

  [[nodiscard]] const MetricFieldDescription& description() const { return description_; }
  [[nodiscard]] const EigenvalueBounds& eigenvalue_bounds() const { return bounds_; }
  /// Whether there are no waves: the metric is flat, and every chart shows the same inner product.
  [[nodiscard]] bool is_constant() const { return description_.waves.empty(); }

  /// An enclosure of G(x), S = Interval (needs a `RoundingGuard`) or BigInterval.
  template <class S>
  [[nodiscard]] Matrix<S, m> at(const Vector<Rational, m>& x) const;
  /// An enclosure of all G(y), |y_k − x_k| ≤ half_widths_k. Needs a `RoundingGuard`.
  [[nodiscard]] Matrix<Interval, m> within(const Vector<Rational, m>& x, const Vector<Rational, m>& half_widths) const;

 private:
  template <class S, class WaveOf>
  [[nodiscard]] Matrix<S, m> summed(const WaveOf& wave_of) const;
  [[nodiscard]] bool exceeds(const Rational& bound, std::size_t most_boxes) const;
  [[nodiscard]] bool stays_below(const Rational& bound, std::size_t most_boxes) const;
  template <class Holds>
  [[nodiscard]] bool holds_everywhere(std::size_t most_boxes, const Holds& holds) const;
  void find_bounds();

  MetricFieldDescription description_;
  EigenvalueBounds bounds_;
};

/// Whether the symmetric matrix is positive definite: whether its leading minors are positive. m = 2, 3.
template <class S, std::size_t m>
[[nodiscard]] Verdict is_positive_definite(const std::array<std::array<S, m>, m>& a) {
  static_assert(m == 2 || m == 3);
  const S second = a[0][0] * a[1][1] - square(a[0][1]);
  Verdict result = conjunction(less(S(0), a[0][0]), less(S(0), second));
  if constexpr (m == 3) {
    const S third = a[2][2] * second - a[1][2] * (a[0][0] * a[1][2] - a[0][1] * a[0][2]) +
                    a[0][2] * (a[0][1] * a[1][2] - a[1][1] * a[0][2]);
    result = conjunction(result, less(S(0), third));
  }
  return result;
}

/// Whether factor·b < a, as quadratic forms.
template <class S, std::size_t m>
[[nodiscard]] Verdict is_above(const std::array<std::array<S, m>, m>& a, const S& factor,
                               const std::array<std::array<S, m>, m>& b) {
  std::array<std::array<S, m>, m> rest;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) rest[row][column] = a[row][column] - factor * b[row][column];
  }
  return is_positive_definite(rest);
}

/// Whether a < factor·b, as quadratic forms.
template <class S, std::size_t m>
[[nodiscard]] Verdict is_below(const std::array<std::array<S, m>, m>& a, const S& factor,
                               const std::array<std::array<S, m>, m>& b) {
  std::array<std::array<S, m>, m> rest;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) rest[row][column] = factor * b[row][column] - a[row][column];
  }
  return is_positive_definite(rest);
}

}  // namespace delcert
