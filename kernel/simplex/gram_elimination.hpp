#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "kernel/number/surd.hpp"
#include "kernel/simplex/partial.hpp"
#include "kernel/simplex/symmetric_matrix.hpp"

namespace delcert {

/// LDLᵀ with diagonal pivoting of a symmetric matrix that may be positive semidefinite.
///
/// A pivot is taken only when it is certainly positive. What is left when there is none decides: nothing left, the
/// matrix is definite; all entries certainly 0, semidefinite and singular, of rank the number of pivots; a diagonal
/// entry certainly negative, or a 2×2 minor, not semidefinite; otherwise undecided. On exact scalars always decided.
template <Scalar S>
class GramElimination {
 public:
  explicit GramElimination(SymmetricMatrix<S> matrix) : reduced_(std::move(matrix)) {
    pivots_.reserve(reduced_.order());
    rest_.reserve(reduced_.order());
    for (std::size_t i = 0; i < reduced_.order(); ++i) rest_.push_back(i);
    while (!rest_.empty() && eliminate_best_pivot()) {
    }
    semidefinite_ = verdict_on_rest();
  }

  [[nodiscard]] Verdict semidefinite() const { return semidefinite_; }
  [[nodiscard]] Verdict definite() const {
    if (is_proved(semidefinite_)) return verdict_of(rest_.empty());
    for (const std::size_t i : rest_) {
      if (is_refuted(less(S(0), reduced_(i, i)))) return Verdict::refuted;
    }
    return semidefinite_;
  }
  /// The number of pivots: the rank if `semidefinite()` is proved, else a lower bound of the number of positive
  /// eigenvalues.
  [[nodiscard]] std::size_t pivot_count() const { return pivots_.size(); }

  /// The determinant. Precondition: `definite()` is proved.
  [[nodiscard]] S determinant() const {
    S result(1);
    for (const std::size_t pivot : pivots_) result = result * reduced_(pivot, pivot);
    return result;
  }

  struct Solution {
    std::vector<S> x;
    S energy;  ///< bᵀx, the same for all solutions x
  };

  /// A solution x of (matrix)·x = b. Refuted if there is none, or the matrix is not semidefinite.
  [[nodiscard]] Partial<Solution> solve(std::vector<S> b) const {
    const Verdict consistent = eliminate(b);
    if (!is_proved(consistent)) return Partial<Solution>::absent(consistent);
    Solution solution{std::vector<S>(b.size(), S(0)), energy_of(b)};
    for (std::size_t position = pivots_.size(); position-- > 0;) {
      const std::size_t pivot = pivots_[position];
      S value = b[pivot] / reduced_(pivot, pivot);
      for (std::size_t later = position + 1; later < pivots_.size(); ++later) {
        const std::size_t i = pivots_[later];
        value = value - reduced_(i, pivot) * solution.x[i];
      }
      solution.x[pivot] = value;
    }
    return solution;
  }

  /// bᵀx for the solutions x of (matrix)·x = b; as `solve`.
  [[nodiscard]] Partial<S> energy(std::vector<S> b) const {
    const Verdict consistent = eliminate(b);
    return is_proved(consistent) ? Partial<S>(energy_of(b)) : Partial<S>::absent(consistent);
  }

 private:
  /// b as the elimination leaves it; whether there is a solution.
  [[nodiscard]] Verdict eliminate(std::vector<S>& b) const {
    for (std::size_t position = 0; position < pivots_.size(); ++position) {
      const std::size_t pivot = pivots_[position];
      for (std::size_t later = position + 1; later < pivots_.size(); ++later) {
        const std::size_t i = pivots_[later];
        b[i] = b[i] - reduced_(i, pivot) * b[pivot];
      }
      for (const std::size_t i : rest_) b[i] = b[i] - reduced_(i, pivot) * b[pivot];
    }
    Verdict consistent = semidefinite_;
    if (!is_proved(consistent)) return consistent;
    for (const std::size_t i : rest_) consistent = conjunction(consistent, is_zero(b[i]));
    return consistent;
  }
  [[nodiscard]] S energy_of(const std::vector<S>& eliminated) const {
    S result(0);
    for (std::size_t position = pivots_.size(); position-- > 0;) {
      const std::size_t pivot = pivots_[position];
      result = result + square(eliminated[pivot]) / reduced_(pivot, pivot);
    }
    return result;
  }

  // Below a pivot, reduced_ holds the multipliers of L; on its diagonal entry, D.
  bool eliminate_best_pivot() {
    std::size_t best = rest_.size();
    for (std::size_t candidate = 0; candidate < rest_.size(); ++candidate) {
      const S& entry = reduced_(rest_[candidate], rest_[candidate]);
      if (is_proved(less(entry, S(0)))) return false;
      if (!is_proved(less(S(0), entry))) continue;
      if (best == rest_.size() || is_proved(less(reduced_(rest_[best], rest_[best]), entry))) best = candidate;
    }
    if (best == rest_.size()) return false;
    const std::size_t pivot = rest_[best];
    rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(best));
    pivots_.push_back(pivot);
    std::vector<S> column;
    column.reserve(rest_.size());
    for (const std::size_t i : rest_) {
      column.push_back(reduced_(i, pivot));
      reduced_(i, pivot) = reduced_(i, pivot) / reduced_(pivot, pivot);
    }
    for (std::size_t a = 0; a < rest_.size(); ++a) {
      reduced_(rest_[a], rest_[a]) = reduced_(rest_[a], rest_[a]) - square(column[a]) / reduced_(pivot, pivot);
      for (std::size_t b = 0; b < a; ++b) {
        S& entry = reduced_(rest_[a], rest_[b]);
        entry = entry - reduced_(rest_[a], pivot) * column[b];
      }
    }
    return true;
  }

  [[nodiscard]] Verdict verdict_on_rest() const {
    Verdict all_zero = Verdict::proved;
    for (const std::size_t i : rest_) {
      if (is_proved(less(reduced_(i, i), S(0)))) return Verdict::refuted;
      all_zero = conjunction(all_zero, is_zero(reduced_(i, i)));
      for (const std::size_t j : rest_) {
        if (j >= i) continue;
        if (is_proved(less(reduced_(i, i) * reduced_(j, j), square(reduced_(i, j))))) return Verdict::refuted;
        all_zero = conjunction(all_zero, is_zero(reduced_(i, j)));
      }
    }
    // Here a refuted `all_zero` only means that an entry is not 0 without breaking semidefiniteness for certain.
    return is_proved(all_zero) ? Verdict::proved : Verdict::undecided;
  }

  SymmetricMatrix<S> reduced_;
  std::vector<std::size_t> pivots_;
  std::vector<std::size_t> rest_;
  Verdict semidefinite_ = Verdict::undecided;
};

/// The same in integers, without fractions, which would be reduced after each operation (Bareiss' elimination).
template <>
class GramElimination<Rational> {
 public:
  explicit GramElimination(const SymmetricMatrix<Rational>& matrix);

  [[nodiscard]] Verdict semidefinite() const { return semidefinite_; }
  [[nodiscard]] Verdict definite() const { return conjunction(semidefinite_, verdict_of(rest_.empty())); }
  [[nodiscard]] std::size_t pivot_count() const { return pivots_.size(); }
  [[nodiscard]] Rational determinant() const;

  struct Solution {
    std::vector<Rational> x;
    Rational energy;
  };
  [[nodiscard]] Partial<Solution> solve(const std::vector<Rational>& b) const;
  [[nodiscard]] Partial<Rational> energy(const std::vector<Rational>& b) const;

 private:
  /// b times a common denominator as the elimination leaves it, and the energy times −determinant.
  struct Eliminated {
    std::vector<Integer> b;
    Integer denominator;
    Integer energy;
    bool is_consistent = false;
  };
  [[nodiscard]] const Integer& at(std::size_t row, std::size_t column) const;
  [[nodiscard]] Integer& at(std::size_t row, std::size_t column);
  [[nodiscard]] bool eliminate_best_pivot();
  [[nodiscard]] Verdict verdict_on_rest() const;
  [[nodiscard]] Eliminated eliminated(const std::vector<Rational>& b) const;
  [[nodiscard]] Rational energy_of(const Eliminated& b) const;

  std::size_t order_;
  Integer denominator_;           ///< of all entries
  std::vector<Integer> reduced_;  ///< the lower triangle; on and below a pivot, what its step was made with
  Integer last_pivot_ = 1;        ///< the determinant of the pivots' rows and columns
  std::vector<std::size_t> pivots_;
  std::vector<std::size_t> rest_;
  Verdict semidefinite_ = Verdict::undecided;
};

/// The same for entries that are rational, in rational numbers; undecided for others.
template <>
class GramElimination<Surd> {
 public:
  explicit GramElimination(const SymmetricMatrix<Surd>& matrix);

  [[nodiscard]] Verdict semidefinite() const { return exact_ ? exact_->semidefinite() : Verdict::undecided; }
  [[nodiscard]] Verdict definite() const { return exact_ ? exact_->definite() : Verdict::undecided; }
  [[nodiscard]] std::size_t pivot_count() const { return exact_ ? exact_->pivot_count() : 0; }
  [[nodiscard]] Surd determinant() const { return exact_ ? Surd(exact_->determinant()) : Surd::unknown(); }

  struct Solution {
    std::vector<Surd> x;
    Surd energy;
  };
  [[nodiscard]] Partial<Solution> solve(const std::vector<Surd>& b) const;
  [[nodiscard]] Partial<Surd> energy(const std::vector<Surd>& b) const;

 private:
  std::optional<GramElimination<Rational>> exact_;
};

}  // namespace delcert
