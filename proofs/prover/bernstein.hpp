#pragma once

#include <flint/fmpz.h>

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/formula/polynomial.hpp"

namespace delcert {

/// What is known of the sign of a term for all points of a set.
enum class Sign : unsigned char { unknown, negative, nonpositive, zero, nonnegative, positive };

[[nodiscard]] std::string_view name_of(Sign sign);
/// The sign of the opposite, of a product, of an even power.
[[nodiscard]] Sign opposite(Sign sign);
[[nodiscard]] Sign product(Sign a, Sign b);
[[nodiscard]] Sign even_power(Sign sign);
[[nodiscard]] inline bool is_strict(Sign sign) { return sign == Sign::positive || sign == Sign::negative; }

/// How one variable runs through the unit interval: y = lower + t·(upper − lower); y = lower + t/(1 − t) if there is no
/// upper end; y = upper − (1 − t)/t if there is no lower one. y grows with t.
/// Precondition: one of them is there, and lower <= upper.
struct UnitMap {
  std::optional<Rational> lower;
  std::optional<Rational> upper;

  /// The value at t; nothing where it is infinite. Precondition: 0 <= t <= 1.
  [[nodiscard]] std::optional<Rational> at(const Rational& t) const;
  /// The t of a value in the range.
  [[nodiscard]] Rational inverse(const Rational& y) const;
};

/// Which ends of the range of each variable do not belong to it.
struct OpenEnds {
  bool lower = false;
  bool upper = false;
};

/// Integers of FLINT, one after the other.
class FlintIntegers {
 public:
  explicit FlintIntegers(std::size_t size);
  FlintIntegers(const FlintIntegers& other);
  FlintIntegers(FlintIntegers&& other) noexcept;
  FlintIntegers& operator=(FlintIntegers other) noexcept;
  ~FlintIntegers();
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] fmpz* at(std::size_t index) { return values_ + index; }
  [[nodiscard]] const fmpz* at(std::size_t index) const { return values_ + index; }

 private:
  fmpz* values_;
  std::size_t size_;
};

/// The Bernstein coefficients of a polynomial on a box, exactly but for a positive factor that all have in common:
/// p(y(t))·Π(1 − t_i)^(d_i)… = c·Σ b_I Π C(d_i, j_i) t_i^(j_i) (1 − t_i)^(d_i − j_i), with the powers of 1 − t_i (of
/// t_i) for variables without upper (lower) end, and c > 0. So p has the signs that the sum has, p(y) lies between the
/// least and the greatest coefficient if all ends are finite, and the coefficients at the corners have the signs of p
/// there.
class BernsteinTensor {
 public:
  /// Precondition: one map for each variable of the ring, and p is not 0.
  /// Throws std::length_error for more than `most` coefficients.
  BernsteinTensor(const Polynomial& p, const std::vector<UnitMap>& box, std::size_t most);

  /// The coefficients on the part 0 <= t <= at of one variable, or at <= t <= 1. Precondition: 0 <= at <= 1.
  [[nodiscard]] BernsteinTensor left_of(std::size_t variable, const Rational& at) const;
  [[nodiscard]] BernsteinTensor right_of(std::size_t variable, const Rational& at) const;

  /// The sign on the box without its open ends, from the coefficients: if none is negative, p >= 0; if further each
  /// face of the box that belongs to it has a positive one among its own coefficients, p > 0.
  [[nodiscard]] Sign sign(const std::vector<OpenEnds>& open) const;

  /// How much the coefficients vary along a variable, between 0 and 1 relative to the greatest; without error bounds.
  [[nodiscard]] double approximate_variation(std::size_t variable) const;

  /// The degree in each variable, and the coefficients, the last variable running fastest.
  [[nodiscard]] const std::vector<unsigned long>& degrees() const { return degrees_; }
  [[nodiscard]] const FlintIntegers& coefficients() const { return coefficients_; }

 private:
  template <class Change>
  void for_each_line(std::size_t variable, const Change& change);
  [[nodiscard]] std::size_t stride(std::size_t variable) const;
  [[nodiscard]] bool has_positive_on_minimal_faces(const std::vector<OpenEnds>& open, int sign) const;
  void subdivide(std::size_t variable, const Rational& at, bool left);
  void map_to_unit(std::size_t variable, const UnitMap& map);
  void remove_content();

  std::vector<unsigned long> degrees_;
  FlintIntegers coefficients_;
};

}  // namespace delcert
