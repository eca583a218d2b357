#include "proofs/prover/sum_of_squares.hpp"

#include <flint/fmpq_mat.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "kernel/number/flint_rational.hpp"
#include "proofs/prover/gram_centre.hpp"

namespace delcert {

namespace {

using ExponentVector = std::vector<unsigned long>;
using ExactRow = std::vector<Rational>;

unsigned long total_exponent(const ExponentVector& exponents) {
  return std::accumulate(exponents.begin(), exponents.end(), 0UL);
}

unsigned long total_degree(const Polynomial& p) {
  unsigned long result = 0;
  for (const auto& term : p.terms()) result = std::max(result, total_exponent(term.exponents));
  return result;
}

bool is_homogeneous(const Polynomial& p) {
  const unsigned long degree = total_degree(p);
  const auto terms = p.terms();
  return std::all_of(terms.begin(), terms.end(),
                     [&](const auto& term) { return total_exponent(term.exponents) == degree; });
}

/// A rational matrix of FLINT.
class RationalMatrix {
 public:
  RationalMatrix(std::size_t rows, std::size_t columns) {
    fmpq_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  RationalMatrix(const RationalMatrix&) = delete;
  RationalMatrix& operator=(const RationalMatrix&) = delete;
  ~RationalMatrix() { fmpq_mat_clear(value_); }
  void set(std::size_t row, std::size_t column, const Rational& x) {
    FlintRational value(x);
    fmpq_set(entry(row, column), value.raw());
  }
  [[nodiscard]] Rational at(std::size_t row, std::size_t column) const {
    FlintRational value;
    fmpq_set(value.raw(), entry(row, column));
    return value.rational();
  }
  [[nodiscard]] bool is_zero(std::size_t row, std::size_t column) const {
    return fmpq_is_zero(entry(row, column)) != 0;
  }
  /// Reduced row echelon form; the columns of the pivots.
  std::vector<std::size_t> reduce() {
    const auto rank = static_cast<std::size_t>(fmpq_mat_rref(value_, value_));
    std::vector<std::size_t> pivots;
    for (std::size_t row = 0, column = 0; row < rank; ++row, ++column) {
      while (is_zero(row, column)) ++column;
      pivots.push_back(column);
    }
    return pivots;
  }

 private:
  [[nodiscard]] fmpq* entry(std::size_t row, std::size_t column) const {
    return fmpq_mat_entry(value_, static_cast<slong>(row), static_cast<slong>(column));
  }
  fmpq_mat_t value_;
};

/// All squares times one product of constraints.
struct SquaresBlock {
  std::vector<std::size_t> constraints;
  Polynomial product;
  std::vector<Polynomial> basis;
};

/// base + Σ yᵢ directionᵢ are all the entries on and below the diagonals of the blocks for which the sum is right.
struct AffineSolutions {
  ExactRow base;
  std::vector<ExactRow> directions;
};

/// A fraction of few digits next to a number; nothing if there is none so close.
std::optional<Rational> simple_fraction_near(double x) {
  for (long denominator = 1; denominator <= 60; ++denominator) {
    const double numerator = std::round(x * static_cast<double>(denominator));
    constexpr double close = 2e-4;
    if (std::abs(numerator) < 1e6 && std::abs(x - numerator / static_cast<double>(denominator)) < close) {
      return Rational(static_cast<long>(numerator)) / Rational(denominator);
    }
  }
  return std::nullopt;
}

/// A rational basis of the space that these vectors span nearly.
std::optional<std::vector<ExactRow>> rational_span(std::vector<std::vector<double>> vectors) {
  std::vector<std::size_t> pivots;
  for (std::size_t row = 0; row < vectors.size(); ++row) {
    std::size_t best_row = row;
    std::size_t best_column = 0;
    double best = 0;
    for (std::size_t i = row; i < vectors.size(); ++i) {
      for (std::size_t j = 0; j < vectors[i].size(); ++j) {
        // Of entries as large, the first: so that symmetric ones do not depend on rounding.
        if (std::abs(vectors[i][j]) > 1.001 * best) {
          best = std::abs(vectors[i][j]);
          best_row = i;
          best_column = j;
        }
      }
    }
    if (best < 1e-8) return std::nullopt;
    std::swap(vectors[row], vectors[best_row]);
    const double pivot = vectors[row][best_column];
    for (double& entry : vectors[row]) entry /= pivot;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      if (i == row) continue;
      const double multiplier = vectors[i][best_column];
      for (std::size_t j = 0; j < vectors[i].size(); ++j) vectors[i][j] -= multiplier * vectors[row][j];
    }
  }
  std::vector<ExactRow> result;
  for (const auto& vector : vectors) {
    result.emplace_back();
    for (const double entry : vector) {
      const auto fraction = simple_fraction_near(entry);
      if (!fraction) return std::nullopt;
      result.back().push_back(*fraction);
    }
  }
  return result;
}

/// A basis of what is orthogonal to the rows.
std::vector<ExactRow> complement_of(const std::vector<ExactRow>& rows, std::size_t width) {
  RationalMatrix matrix(std::max<std::size_t>(rows.size(), 1), width);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < width; ++j) matrix.set(i, j, rows[i][j]);
  }
  const auto pivots = matrix.reduce();
  std::vector<ExactRow> result;
  for (std::size_t free = 0; free < width; ++free) {
    if (std::find(pivots.begin(), pivots.end(), free) != pivots.end()) continue;
    ExactRow vector(width, Rational(0));
    vector[free] = Rational(1);
    for (std::size_t row = 0; row < pivots.size(); ++row) vector[pivots[row]] = -matrix.at(row, free);
    result.push_back(std::move(vector));
  }
  return result;
}

class GramSearch {
 public:
  GramSearch(const Polynomial& polynomial, const std::vector<Polynomial>& constraints)
      : polynomial_(polynomial), constraints_(constraints), degree_(total_degree(polynomial)) {}

  std::optional<std::vector<SquareTerm>> run(std::size_t most_factors, unsigned long degree) {
    choose_blocks(most_factors, degree);
    constexpr int most_faces = 6;
    for (int face = 0; face < most_faces && !blocks_.empty(); ++face) {
      const auto solutions = solve();
      if (!solutions || solutions->directions.size() > most_directions) return std::nullopt;
      const ApproximateCentre centre = approximate_centre(families(*solutions));
      if (!centre.is_found) return std::nullopt;
      if (centre.is_inside) return rounded(*solutions, centre.y);
      if (!restrict_to(centre.null_vectors)) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t most_directions = 260;
  static constexpr std::size_t most_entries = 900;
  static constexpr std::size_t largest_basis = 40;

  /// Which variables a square may have: those of the polynomial.
  [[nodiscard]] std::vector<Polynomial> monomials(unsigned long least, unsigned long most) const {
    const auto degrees = polynomial_.degrees();
    std::vector<std::pair<Polynomial, unsigned long>> all{{Polynomial(polynomial_.ring(), Rational(1)), 0}};
    for (std::size_t variable = 0; variable < degrees.size(); ++variable) {
      if (degrees[variable] == 0) continue;
      const Polynomial x = Polynomial::variable(polynomial_.ring(), variable);
      const std::size_t before = all.size();
      for (std::size_t i = 0; i < before; ++i) {
        Polynomial power = all[i].first;
        for (unsigned long exponent = 1; all[i].second + exponent <= most; ++exponent) {
          power = power * x;
          all.emplace_back(power, all[i].second + exponent);
          if (all.size() > 2000) return {};
        }
      }
    }
    std::vector<Polynomial> result;
    for (auto& [monomial, degree] : all) {
      if (degree >= least) result.push_back(std::move(monomial));
    }
    return result;
  }

  void choose_blocks(std::size_t most_factors, unsigned long degree) {
    blocks_.clear();
    const bool homogeneous = is_homogeneous(polynomial_) && degree == degree_;
    const Polynomial one(polynomial_.ring(), Rational(1));
    std::vector<std::pair<std::vector<std::size_t>, Polynomial>> products{{{}, one}};
    for (std::size_t i = 0; i < constraints_.size() && most_factors >= 1; ++i) {
      products.push_back({{i}, constraints_[i]});
      for (std::size_t j = 0; j < i && most_factors >= 2; ++j) {
        products.push_back({{j, i}, constraints_[j] * constraints_[i]});
      }
    }
    std::size_t entries = 0;
    for (auto& [numbers, product] : products) {
      const unsigned long its_degree = total_degree(product);
      if (its_degree > degree) continue;
      const unsigned long rest = degree - its_degree;
      if (homogeneous && (rest % 2 != 0 || !is_homogeneous(product))) continue;
      auto basis = monomials(homogeneous ? rest / 2 : 0, rest / 2);
      if (numbers.empty()) prune(basis, most_factors);
      if (basis.empty()) continue;
      entries += basis.size() * (basis.size() + 1) / 2;
      if (basis.size() > largest_basis || entries > most_entries) {
        blocks_.clear();
        return;
      }
      blocks_.push_back({numbers, product, std::move(basis)});
    }
  }

  /// Without constraints, a monomial whose square no other product cancels has to be in the polynomial, or is not used.
  void prune(std::vector<Polynomial>& basis, std::size_t most_factors) const {
    if (most_factors > 0) return;
    std::map<ExponentVector, bool> support;
    for (const auto& term : polynomial_.terms()) support[term.exponents] = true;
    for (bool changed = true; changed;) {
      changed = false;
      std::map<ExponentVector, int> mixed;
      for (std::size_t i = 0; i < basis.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) ++mixed[(basis[i] * basis[j]).terms().front().exponents];
      }
      const auto is_useless = [&](const Polynomial& monomial) {
        const ExponentVector square = (monomial * monomial).terms().front().exponents;
        return !support.contains(square) && !mixed.contains(square);
      };
      const auto end = std::remove_if(basis.begin(), basis.end(), is_useless);
      changed = end != basis.end();
      basis.erase(end, basis.end());
    }
  }

  /// One equation for each monomial; nothing if the polynomial is no such sum whatever the signs.
  [[nodiscard]] std::optional<AffineSolutions> solve() const {
    std::vector<std::vector<Polynomial::Term>> columns;
    std::map<ExponentVector, std::size_t> rows;
    const auto row_of = [&rows](const ExponentVector& exponents) {
      return rows.try_emplace(exponents, rows.size()).first->second;
    };
    for (const auto& term : polynomial_.terms()) (void)row_of(term.exponents);
    for (const SquaresBlock& block : blocks_) {
      for (std::size_t i = 0; i < block.basis.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          const Polynomial twice(polynomial_.ring(), Rational(i == j ? 1 : 2));
          columns.push_back((twice * block.product * block.basis[i] * block.basis[j]).terms());
          for (const auto& term : columns.back()) (void)row_of(term.exponents);
        }
      }
    }
    RationalMatrix matrix(rows.size(), columns.size() + 1);
    for (std::size_t column = 0; column < columns.size(); ++column) {
      for (const auto& term : columns[column]) matrix.set(row_of(term.exponents), column, term.coefficient);
    }
    for (const auto& term : polynomial_.terms()) matrix.set(row_of(term.exponents), columns.size(), term.coefficient);
    const auto pivots = matrix.reduce();
    if (!pivots.empty() && pivots.back() == columns.size()) return std::nullopt;
    AffineSolutions result{ExactRow(columns.size(), Rational(0)), {}};
    for (std::size_t row = 0; row < pivots.size(); ++row) result.base[pivots[row]] = matrix.at(row, columns.size());
    if (columns.size() - pivots.size() > most_directions) return std::nullopt;
    for (std::size_t free = 0; free < columns.size(); ++free) {
      if (std::find(pivots.begin(), pivots.end(), free) != pivots.end()) continue;
      ExactRow direction(columns.size(), Rational(0));
      direction[free] = Rational(1);
      for (std::size_t row = 0; row < pivots.size(); ++row) {
        if (!matrix.is_zero(row, free)) direction[pivots[row]] = -matrix.at(row, free);
      }
      result.directions.push_back(std::move(direction));
    }
    return result;
  }

  [[nodiscard]] std::vector<GramBlock> families(const AffineSolutions& solutions) const {
    std::vector<GramBlock> result;
    std::size_t at = 0;
    for (const SquaresBlock& block : blocks_) {
      const std::size_t order = block.basis.size();
      const auto rows = [&](const ExactRow& entries) {
        std::vector<double> matrix(order * order);
        std::size_t entry = at;
        for (std::size_t i = 0; i < order; ++i) {
          for (std::size_t j = 0; j <= i; ++j, ++entry) {
            matrix[i * order + j] = matrix[j * order + i] = nearest_double(entries[entry]);
          }
        }
        return matrix;
      };
      GramBlock family{order, rows(solutions.base), {}};
      for (const ExactRow& direction : solutions.directions) family.directions.push_back(rows(direction));
      result.push_back(std::move(family));
      at += order * (order + 1) / 2;
    }
    return result;
  }

  static double nearest_double(const Rational& x) { return mpq_get_d(x.gmp()); }

  /// Only what is orthogonal to the null vectors; false if they are not rational, or there are none.
  bool restrict_to(const std::vector<std::vector<std::vector<double>>>& null_vectors) {
    bool changed = false;
    std::vector<SquaresBlock> restricted;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const SquaresBlock& block = blocks_[b];
      if (null_vectors[b].empty()) {
        restricted.push_back(block);
        continue;
      }
      changed = true;
      const auto span = rational_span(null_vectors[b]);
      if (!span) return false;
      SquaresBlock smaller{block.constraints, block.product, {}};
      for (const ExactRow& vector : complement_of(*span, block.basis.size())) {
        Polynomial element(polynomial_.ring());
        for (std::size_t i = 0; i < vector.size(); ++i) {
          if (vector[i] != Rational(0)) element = element + Polynomial(polynomial_.ring(), vector[i]) * block.basis[i];
        }
        smaller.basis.push_back(std::move(element));
      }
      if (!smaller.basis.empty()) restricted.push_back(std::move(smaller));
    }
    blocks_ = std::move(restricted);
    return changed;
  }

  /// The parameters to more and more digits, until the exact matrices are positive definite.
  [[nodiscard]] std::optional<std::vector<SquareTerm>> rounded(const AffineSolutions& solutions,
                                                               const std::vector<double>& y) const {
    for (const long bits : {1L, 3L, 6L, 10L, 16L, 24L, 36L}) {
      ExactRow entries = solutions.base;
      for (std::size_t i = 0; i < y.size(); ++i) {
        const double scaled = std::round(std::ldexp(y[i], static_cast<int>(bits)));
        if (!(std::abs(scaled) < 0x1p60)) return std::nullopt;
        const Rational value = Rational(static_cast<long>(scaled)) * Rational::power_of_two(-bits);
        for (std::size_t entry = 0; entry < entries.size(); ++entry) {
          if (solutions.directions[i][entry] != Rational(0)) entries[entry] += value * solutions.directions[i][entry];
        }
      }
      auto terms = terms_of(entries);
      if (terms && is_sum(polynomial_, constraints_, *terms)) return terms;
    }
    return std::nullopt;
  }

  /// LDLᵀ of each block: Σ dᵢ (Σ_j L_ji basis_j)². Nothing unless all dᵢ are above 0, or the rest of a column is 0.
  [[nodiscard]] std::optional<std::vector<SquareTerm>> terms_of(const ExactRow& entries) const {
    std::vector<SquareTerm> result;
    std::size_t at = 0;
    for (const SquaresBlock& block : blocks_) {
      const std::size_t order = block.basis.size();
      std::vector<ExactRow> matrix(order, ExactRow(order));
      for (std::size_t i = 0; i < order; ++i) {
        for (std::size_t j = 0; j <= i; ++j) matrix[i][j] = matrix[j][i] = entries[at++];
      }
      for (std::size_t pivot = 0; pivot < order; ++pivot) {
        const Rational d = matrix[pivot][pivot];
        if (d < Rational(0)) return std::nullopt;
        if (d == Rational(0)) {
          for (std::size_t i = pivot; i < order; ++i) {
            if (matrix[i][pivot] != Rational(0)) return std::nullopt;
          }
          continue;
        }
        Polynomial base = block.basis[pivot];
        for (std::size_t i = pivot + 1; i < order; ++i) {
          const Rational multiplier = matrix[i][pivot] / d;
          if (multiplier == Rational(0)) continue;
          base = base + Polynomial(polynomial_.ring(), multiplier) * block.basis[i];
          for (std::size_t j = pivot + 1; j < order; ++j) matrix[i][j] -= multiplier * matrix[pivot][j];
        }
        result.push_back({d, std::move(base), block.constraints});
      }
    }
    return result;
  }

  const Polynomial& polynomial_;
  const std::vector<Polynomial>& constraints_;
  unsigned long degree_;
  std::vector<SquaresBlock> blocks_;
};

}  // namespace

bool is_sum(const Polynomial& polynomial, const std::vector<Polynomial>& constraints,
            const std::vector<SquareTerm>& terms) {
  Polynomial rest = polynomial;
  for (const SquareTerm& term : terms) {
    if (!(Rational(0) < term.weight)) return false;
    Polynomial product = Polynomial(polynomial.ring(), term.weight) * term.base * term.base;
    for (const std::size_t constraint : term.constraints) product = product * constraints.at(constraint);
    rest = rest - product;
  }
  return rest.is_zero();
}

std::optional<std::vector<SquareTerm>> sum_of_squares(const Polynomial& polynomial,
                                                      const std::vector<Polynomial>& constraints) {
  constexpr unsigned long highest_degree = 12;
  constexpr std::size_t most_constraints = 12;
  if (polynomial.is_zero()) return std::vector<SquareTerm>();
  const unsigned long degree = total_degree(polynomial);
  if (degree > highest_degree || constraints.size() > most_constraints) return std::nullopt;
  GramSearch search(polynomial, constraints);
  for (std::size_t factors = 0; factors <= std::min<std::size_t>(2, constraints.size()); ++factors) {
    if (factors == 0 && degree % 2 != 0) continue;
    if (auto found = search.run(factors, degree)) return found;
    if (factors > 0 && degree % 2 != 0) {
      if (auto found = search.run(factors, degree + 1)) return found;
    }
  }
  return std::nullopt;
}

std::optional<std::vector<SquareTerm>> positive_sum_of_squares(const Polynomial& polynomial,
                                                               const std::vector<Polynomial>& constraints) {
  const Polynomial one(polynomial.ring(), Rational(1));
  for (const long exponent : {0L, -4L, -10L, -20L}) {
    const Rational least = Rational::power_of_two(exponent);
    auto found = sum_of_squares(polynomial - Polynomial(polynomial.ring(), least), constraints);
    if (!found) continue;
    found->push_back({least, one, {}});
    return found;
  }
  return std::nullopt;
}

}  // namespace delcert
