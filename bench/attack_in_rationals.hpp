#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernel/simplex/altitude.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/edges.hpp"
#include "kernel/simplex/singular_values.hpp"
#include "proofs/formula/simplex_object.hpp"

// What an attack decides of an instance, as a program would that has rational numbers only: the hypothesis, all
// conclusions, whether the simplex is thin, and the ratio where it may be the worst so far. Roots are squared away.

namespace delcert {

/// GMP's rational numbers as they are: every operation in lowest terms.
class Fraction {
 public:
  using Gmp = Rational::Wrapped;

  Fraction(int integer) : value_(integer) {}
  Fraction(const Rational& value) : value_(value.wrapped()) {}

  friend Fraction operator+(const Fraction& a, const Fraction& b) { return Fraction(Gmp(a.value_ + b.value_)); }
  friend Fraction operator-(const Fraction& a, const Fraction& b) { return Fraction(Gmp(a.value_ - b.value_)); }
  friend Fraction operator*(const Fraction& a, const Fraction& b) { return Fraction(Gmp(a.value_ * b.value_)); }
  friend Fraction operator/(const Fraction& a, const Fraction& b) { return Fraction(Gmp(a.value_ / b.value_)); }
  friend Fraction square(const Fraction& a) { return a * a; }
  friend Fraction minimum(const Fraction& a, const Fraction& b) { return b.value_ < a.value_ ? b : a; }
  friend Fraction maximum(const Fraction& a, const Fraction& b) { return a.value_ < b.value_ ? b : a; }
  friend Verdict less(const Fraction& a, const Fraction& b) { return verdict_of(a.value_ < b.value_); }
  friend Verdict less_equal(const Fraction& a, const Fraction& b) { return verdict_of(a.value_ <= b.value_); }
  friend Verdict is_zero(const Fraction& a) { return verdict_of(a.value_.is_zero()); }
  [[nodiscard]] double approximately() const { return mpq_get_d(value_.backend().data()); }

 private:
  explicit Fraction(Gmp value) : value_(std::move(value)) {}
  Gmp value_;
};

inline double approximately(const Fraction& x) { return x.approximately(); }
inline double approximately(const Rational& x) { return approximate_double(x); }

/// In fractions, or, for Q = Rational, in integers over a common denominator, as all of the elimination is then.
template <class Q>
EdgeGram<Q> gram_in(const SimplexObject& simplex) {
  std::vector<std::vector<Q>> points;
  for (const auto& point : simplex.points()) points.emplace_back(point.begin(), point.end());
  return edge_gram_from_points(points);
}

/// The squares of all altitudes, of which thickness and dual lengths make use.
template <class Q>
std::vector<Q> squared_altitudes(const EdgeGram<Q>& gram) {
  std::vector<Q> result;
  for (std::size_t p = 0; p < gram.vertex_count(); ++p) result.push_back(*squared_altitude(gram, p));
  return result;
}

template <class Q>
Q least_of(const std::vector<Q>& numbers) {
  Q result = numbers.front();
  for (const Q& number : numbers) result = minimum(result, number);
  return result;
}

/// What is counted of one conclusion.
template <class Q>
struct RationalTally {
  std::uint64_t held = 0;
  std::optional<Q> worst_squared;  ///< ratio

  void count(Verdict verdict) { held += is_proved(verdict) ? 1U : 0U; }
  void measure(const Q& squared_ratio) {
    if (!worst_squared || is_proved(less(*worst_squared, squared_ratio))) worst_squared = squared_ratio;
  }
};

/// The samples of an attack on `crude-circumradius-bound`.
template <class Q>
class CrudeRadiusInRationals {
 public:
  void decide(const SimplexObject& simplex) {
    const EdgeGram<Q> gram = gram_in<Q>(simplex);
    const Partial<Q> radius = squared_circumradius(gram);
    // Every simplex has one but a degenerate one.
    if (!radius) return;
    const int k = static_cast<int>(gram.dimension());
    const Q longest = squared_longest_edge(gram);
    const Q thickness = least_of(squared_altitudes(gram)) / Q(Q(k * k) * longest);
    if (is_proved(less(thickness, thin_))) ++thin_count_;
    // R² ≤ Δ²/(4Υ²)
    const Q ratio = Q(4) * *radius * thickness / longest;
    conclusions_[0].count(less_equal(ratio, Q(1)));
    conclusions_[0].measure(ratio);
  }
  [[nodiscard]] std::span<const RationalTally<Q>> conclusions() const { return conclusions_; }

 private:
  Q thin_ = Q(Rational::power_of_two(-40));
  std::size_t thin_count_ = 0;
  std::array<RationalTally<Q>, 1> conclusions_;
};

/// The samples of an attack on `thickness-and-singular-value`.
template <class Q>
class SingularValueInRationals {
 public:
  void decide(const SimplexObject& simplex) {
    const EdgeGram<Q> gram = gram_in<Q>(simplex);
    const GramElimination<Q> elimination(gram.gram());
    if (!is_proved(elimination.definite())) return;
    const std::size_t k = gram.dimension();
    const std::vector<Q> altitudes = squared_altitudes(gram);

    std::vector<std::vector<Q>> inverse;
    for (std::size_t i = 0; i < k; ++i) {
      std::vector<Q> unit(k, Q(0));
      unit[i] = Q(1);
      inverse.push_back(elimination.solve(unit)->x);
    }
    decide_dual_basis(simplex, inverse);

    Verdict lengths_fit = Verdict::proved;
    for (std::size_t i = 0; i < k; ++i) {
      const Q product = altitudes[i + 1] * inverse[i][i];
      lengths_fit = conjunction(lengths_fit, is_zero(Q(product - Q(1))));
      conclusions_[2].measure(product);
    }
    conclusions_[2].count(lengths_fit);

    const Q least = least_of(altitudes);
    const Q thin = thin_ * Q(static_cast<int>(k * k)) * squared_longest_edge(gram);
    if (is_proved(less(least, thin))) ++thin_count_;
    decide_singular_value(gram, Q(least / Q(static_cast<int>(k))));
  }
  /// In the order of the claim.
  [[nodiscard]] std::span<const RationalTally<Q>> conclusions() const { return conclusions_; }

 private:
  /// The inner products of the dual vectors, by their coordinates, with the edges.
  void decide_dual_basis(const SimplexObject& simplex, const std::vector<std::vector<Q>>& inverse) {
    const std::size_t k = inverse.size();
    const std::size_t m = simplex.ambient_dimension();
    std::vector<std::vector<Q>> edges;
    for (std::size_t i = 0; i < k; ++i) {
      auto& edge = edges.emplace_back();
      for (std::size_t axis = 0; axis < m; ++axis) {
        edge.push_back(Q(simplex.points()[i + 1][axis]) - Q(simplex.points()[0][axis]));
      }
    }
    Verdict are_dual = Verdict::proved;
    Verdict are_orthogonal = Verdict::proved;
    for (std::size_t i = 0; i < k; ++i) {
      std::vector<Q> dual(m, Q(0));
      for (std::size_t axis = 0; axis < m; ++axis) {
        for (std::size_t j = 0; j < k; ++j) dual[axis] = dual[axis] + inverse[i][j] * edges[j][axis];
      }
      for (std::size_t j = 0; j < k; ++j) {
        Q product(0);
        for (std::size_t axis = 0; axis < m; ++axis) product = product + dual[axis] * edges[j][axis];
        if (i == j) {
          are_dual = conjunction(are_dual, is_zero(Q(product - Q(1))));
          conclusions_[0].measure(square(product));
        } else {
          are_orthogonal = conjunction(are_orthogonal, is_zero(product));
        }
      }
    }
    conclusions_[0].count(are_dual);
    conclusions_[1].count(are_orthogonal);
  }

  /// s_k(P)² ≥ bound = kΥ²Δ²; and their ratio up to 2⁻²⁰, by bisection, unless it is not above the worst.
  void decide_singular_value(const EdgeGram<Q>& gram, const Q& bound) {
    const auto is_ratio_at_most = [&](const Q& squared_ratio) {
      return is_proved(is_smallest_singular_value_at_least(gram, Q(bound / squared_ratio)));
    };
    auto& tally = conclusions_[3];
    const Verdict verdict = is_smallest_singular_value_at_least(gram, bound);
    tally.count(verdict);
    if (tally.worst_squared && is_ratio_at_most(*tally.worst_squared)) return;
    Q upper(1);
    while (!is_ratio_at_most(upper)) upper = upper * Q(2);
    Q lower = upper / Q(2);
    if (tally.worst_squared) {
      lower = maximum(lower, *tally.worst_squared);
    } else {
      while (is_ratio_at_most(lower)) lower = lower / Q(2);
    }
    while (is_proved(less(Q(fine_ * upper), Q(upper - lower)))) {
      const Q middle = (lower + upper) / Q(2);
      (is_ratio_at_most(middle) ? upper : lower) = middle;
    }
    tally.measure(lower);
  }

  Q thin_ = Q(Rational::power_of_two(-40));
  Q fine_ = Q(Rational::power_of_two(-19));
  std::size_t thin_count_ = 0;
  std::array<RationalTally<Q>, 4> conclusions_;
};

}  // namespace delcert
