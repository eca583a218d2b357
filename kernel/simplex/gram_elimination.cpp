#include "kernel/simplex/gram_elimination.hpp"

#include <algorithm>

#include "kernel/simplex/fraction_free.hpp"

namespace delcert {

const Integer& GramElimination<Rational>::at(std::size_t row, std::size_t column) const {
  if (row < column) std::swap(row, column);
  return reduced_[row * (row + 1) / 2 + column];
}

Integer& GramElimination<Rational>::at(std::size_t row, std::size_t column) {
  if (row < column) std::swap(row, column);
  return reduced_[row * (row + 1) / 2 + column];
}

GramElimination<Rational>::GramElimination(const SymmetricMatrix<Rational>& matrix)
    : order_(matrix.order()), denominator_(1) {
  for (std::size_t row = 0; row < order_; ++row) {
    rest_.push_back(row);
    for (std::size_t column = 0; column <= row; ++column) include_denominator(denominator_, matrix(row, column));
  }
  for (std::size_t row = 0; row < order_; ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      reduced_.push_back(whole_multiple(matrix(row, column), denominator_));
    }
  }
  while (!rest_.empty() && eliminate_best_pivot()) {
  }
  semidefinite_ = verdict_on_rest();
}

bool GramElimination<Rational>::eliminate_best_pivot() {
  std::size_t best = rest_.size();
  for (std::size_t candidate = 0; candidate < rest_.size(); ++candidate) {
    const Integer& entry = at(rest_[candidate], rest_[candidate]);
    if (entry < 0) return false;
    if (entry > 0 && (best == rest_.size() || entry > at(rest_[best], rest_[best]))) best = candidate;
  }
  if (best == rest_.size()) return false;
  const std::size_t pivot = rest_[best];
  rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(best));
  pivots_.push_back(pivot);
  for (std::size_t a = 0; a < rest_.size(); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      eliminate(at(rest_[a], rest_[b]), at(pivot, pivot), at(rest_[a], pivot), at(rest_[b], pivot), last_pivot_);
    }
  }
  last_pivot_ = at(pivot, pivot);
  return true;
}

Verdict GramElimination<Rational>::verdict_on_rest() const {
  bool all_zero = true;
  for (const std::size_t i : rest_) {
    for (const std::size_t j : rest_) all_zero = all_zero && at(i, j) == 0;
  }
  // With no pivot left, some entry is negative, or one beside a zero is not 0.
  return verdict_of(all_zero);
}

Rational GramElimination<Rational>::determinant() const {
  return Rational(last_pivot_) / power(Rational(denominator_), static_cast<long>(order_));
}

GramElimination<Rational>::Eliminated GramElimination<Rational>::eliminated(const std::vector<Rational>& b) const {
  Eliminated result{{}, 1, 0, is_proved(semidefinite_)};
  for (const Rational& entry : b) include_denominator(result.denominator, entry);
  for (const Rational& entry : b) result.b.push_back(whole_multiple(entry, result.denominator));
  Integer previous = 1;
  for (std::size_t position = 0; position < pivots_.size(); ++position) {
    const std::size_t pivot = pivots_[position];
    const auto reduce_entry = [&](std::size_t i) {
      eliminate(result.b[i], at(pivot, pivot), at(i, pivot), result.b[pivot], previous);
    };
    for (std::size_t later = position + 1; later < pivots_.size(); ++later) reduce_entry(pivots_[later]);
    std::for_each(rest_.begin(), rest_.end(), reduce_entry);
    eliminate(result.energy, at(pivot, pivot), result.b[pivot], result.b[pivot], previous);
    previous = at(pivot, pivot);
  }
  for (const std::size_t i : rest_) result.is_consistent = result.is_consistent && result.b[i] == 0;
  return result;
}

Rational GramElimination<Rational>::energy_of(const Eliminated& b) const {
  return Rational(Integer(-b.energy * denominator_), Integer(b.denominator * b.denominator * last_pivot_));
}

Partial<GramElimination<Rational>::Solution> GramElimination<Rational>::solve(const std::vector<Rational>& b) const {
  const Eliminated reduced = eliminated(b);
  if (!reduced.is_consistent) return Partial<Solution>::absent(Verdict::refuted);
  // By Cramer's rule the determinant times the solution is integral.
  std::vector<Integer> multiple(order_, Integer(0));
  for (std::size_t position = pivots_.size(); position-- > 0;) {
    const std::size_t pivot = pivots_[position];
    Integer& value = multiple[pivot];
    value = last_pivot_ * reduced.b[pivot];
    for (std::size_t later = position + 1; later < pivots_.size(); ++later) {
      mpz_submul(raw(value), raw(at(pivots_[later], pivot)), raw(multiple[pivots_[later]]));
    }
    mpz_divexact(raw(value), raw(value), raw(at(pivot, pivot)));
  }
  const Integer divisor = reduced.denominator * last_pivot_;
  Solution result{{}, energy_of(reduced)};
  for (const Integer& value : multiple) result.x.emplace_back(Integer(value * denominator_), divisor);
  return result;
}

Partial<Rational> GramElimination<Rational>::energy(const std::vector<Rational>& b) const {
  const Eliminated reduced = eliminated(b);
  return reduced.is_consistent ? Partial<Rational>(energy_of(reduced)) : Partial<Rational>::absent(Verdict::refuted);
}

namespace {

std::optional<std::vector<Rational>> rationals(const std::vector<Surd>& numbers) {
  std::vector<Rational> result;
  for (const Surd& number : numbers) {
    auto value = number.rational();
    if (!value) return std::nullopt;
    result.push_back(*std::move(value));
  }
  return result;
}

}  // namespace

GramElimination<Surd>::GramElimination(const SymmetricMatrix<Surd>& matrix) {
  SymmetricMatrix<Rational> exact(matrix.order());
  for (std::size_t row = 0; row < matrix.order(); ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      auto entry = matrix(row, column).rational();
      if (!entry) return;
      exact(row, column) = *std::move(entry);
    }
  }
  exact_.emplace(exact);
}

Partial<GramElimination<Surd>::Solution> GramElimination<Surd>::solve(const std::vector<Surd>& b) const {
  const auto right = rationals(b);
  if (!exact_ || !right) return Partial<Solution>::absent(Verdict::undecided);
  const auto solution = exact_->solve(*right);
  if (!solution) return Partial<Solution>::absent(solution.exists());
  Solution result{{}, Surd(solution->energy)};
  for (const Rational& x : solution->x) result.x.emplace_back(x);
  return result;
}

Partial<Surd> GramElimination<Surd>::energy(const std::vector<Surd>& b) const {
  const auto right = rationals(b);
  if (!exact_ || !right) return Partial<Surd>::absent(Verdict::undecided);
  const auto energy = exact_->energy(*right);
  return energy ? Partial<Surd>(Surd(*energy)) : Partial<Surd>::absent(energy.exists());
}

}  // namespace delcert
