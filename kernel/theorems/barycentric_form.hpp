#pragma once

#include <array>
#include <vector>

#include "kernel/number/interval.hpp"

namespace delcert {

/// A homogeneous polynomial in the barycentric coordinates t_0 … t_m of an m-simplex, m = 2, 3, of degree at most 2m;
/// its coefficients are enclosed. Every polynomial on the simplex is one, as Σ t_v = 1. All needs a `RoundingGuard`.
template <int m>
class BarycentricForm {
 public:
  static constexpr std::size_t greatest_degree = 2 * m;

  /// 0. Precondition: degree ≤ greatest_degree.
  explicit BarycentricForm(std::size_t degree);

  [[nodiscard]] std::size_t degree() const { return degree_; }
  /// Of t_k·t_l. Precondition: the degree is 2.
  [[nodiscard]] Interval& of_pair(std::size_t k, std::size_t l);

  /// Precondition: their degrees are equal.
  BarycentricForm& operator+=(const BarycentricForm& other);
  BarycentricForm& operator-=(const BarycentricForm& other);

  /// Not above any value on the simplex: the least coefficient in Bernstein's basis. It may be minus infinity.
  [[nodiscard]] double least_control() const;

  template <int n>
  friend BarycentricForm<n> product(const BarycentricForm<n>& a, const BarycentricForm<n>& b);

 private:
  std::size_t degree_;
  std::vector<Interval> coefficients_;  // of the monomials, in the order of the tables
};

/// Precondition: the degrees add up to greatest_degree at most.
template <int m>
[[nodiscard]] BarycentricForm<m> product(const BarycentricForm<m>& a, const BarycentricForm<m>& b);

/// Row by row, each of degree 2.
template <int m>
using FormMatrix = std::vector<BarycentricForm<m>>;

/// Of degree 2m.
template <int m>
[[nodiscard]] BarycentricForm<m> determinant(const FormMatrix<m>& a);

}  // namespace delcert
