#include "proofs/formula/pair_alignment.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "kernel/simplex/gram_elimination.hpp"

namespace delcert {

namespace {

/// By rows.
template <class S>
using Matrix = std::vector<std::vector<S>>;

Interval below(const Interval& x) { return Interval::exactly(x.lower()); }
Interval middle(const Interval& x) { return Interval::exactly(x.lower() + (x.upper() - x.lower()) / 2); }
Interval joined(const Interval& least, const Interval& greatest) {
  return Interval::between(std::min(least.lower(), greatest.upper()), greatest.upper());
}
bool is_bounded(const Interval& x) {
  return x.lower() >= std::numeric_limits<double>::lowest() && x.upper() <= std::numeric_limits<double>::max();
}

BigInterval below(const BigInterval& x) { return BigInterval::between(x.lower(), x.lower()); }
/// An end, which is faster to have than the mean, and as good.
BigInterval middle(const BigInterval& x) { return below(x); }
BigInterval joined(const BigInterval& least, const BigInterval& greatest) {
  return BigInterval::between(minimum(least.lower(), greatest.upper()), greatest.upper());
}
bool is_bounded(const BigInterval& x) { return x.is_bounded(); }

template <class S>
long precision_bits() {
  if constexpr (std::same_as<S, Interval>) return 53;
  return static_cast<long>(BigInterval::working_precision().value);
}

template <class S>
Matrix<S> zero_matrix(std::size_t order) {
  return Matrix<S>(order, std::vector<S>(order, S(0)));
}

template <class S>
bool is_bounded(const Matrix<S>& matrix) {
  for (const auto& row : matrix) {
    for (const S& entry : row) {
      if (!is_bounded(entry)) return false;
    }
  }
  return true;
}

template <class S>
Matrix<S> middle(const Matrix<S>& matrix) {
  Matrix<S> result = matrix;
  for (auto& row : result) {
    for (S& entry : row) entry = middle(entry);
  }
  return result;
}

/// The upper triangular P with PᵀP the Gram matrix, on intervals.
std::optional<Matrix<Interval>> triangular_factor(Evaluation<Interval>& evaluation, const SimplexObject& simplex) {
  const auto& gram = simplex.gram(evaluation).gram();
  auto result = zero_matrix<Interval>(gram.order());
  for (std::size_t row = 0; row < gram.order(); ++row) {
    for (std::size_t column = row; column < gram.order(); ++column) {
      Interval entry = gram(row, column);
      for (std::size_t above = 0; above < row; ++above) {
        entry = entry - (row == column ? square(result[above][row]) : result[above][row] * result[above][column]);
      }
      if (row == column && !(entry.lower() > 0)) return std::nullopt;
      result[row][column] = row == column ? square_root(entry) : entry / result[row][row];
    }
  }
  return result;
}

/// The same from an exact elimination, which also serves degenerate simplices.
std::optional<Matrix<BigInterval>> triangular_factor(Evaluation<BigInterval>&, const SimplexObject& simplex) {
  SymmetricMatrix<Rational> rest = simplex.exact_gram().gram();
  auto result = zero_matrix<BigInterval>(rest.order());
  for (std::size_t row = 0; row < rest.order(); ++row) {
    const Rational pivot = rest(row, row);
    // A Gram matrix is semidefinite: with the pivot, what belongs to it is 0.
    if (pivot == Rational(0)) continue;
    const BigInterval root = square_root(BigInterval(pivot));
    result[row][row] = root;
    for (std::size_t i = row + 1; i < rest.order(); ++i) {
      const Rational multiplier = rest(i, row) / pivot;
      result[row][i] = root * BigInterval(multiplier);
      for (std::size_t j = row + 1; j <= i; ++j) rest(i, j) -= multiplier * rest(j, row);
    }
  }
  return result;
}

/// An approximation of P̃P⁻¹ for triangular P.
template <class S>
Matrix<S> quotient(const Matrix<S>& image, const Matrix<S>& triangular) {
  const std::size_t order = image.size();
  auto result = zero_matrix<S>(order);
  for (std::size_t row = 0; row < order; ++row) {
    for (std::size_t column = 0; column < order; ++column) {
      S entry = image[row][column];
      for (std::size_t before = 0; before < column; ++before) {
        entry = entry - result[row][before] * triangular[before][column];
      }
      result[row][column] = middle(S(entry / triangular[column][column]));
    }
  }
  return result;
}

/// An approximation of the inverse, by Gauss and Jordan with row pivots; nothing if the matrix may be singular.
template <class S>
std::optional<Matrix<S>> approximate_inverse(Matrix<S> matrix) {
  const std::size_t order = matrix.size();
  auto result = zero_matrix<S>(order);
  for (std::size_t i = 0; i < order; ++i) result[i][i] = S(1);
  for (std::size_t column = 0; column < order; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < order; ++row) {
      if (is_proved(less(absolute(matrix[pivot][column]), absolute(matrix[row][column])))) pivot = row;
    }
    if (!is_refuted(is_zero(matrix[pivot][column]))) return std::nullopt;
    std::swap(matrix[pivot], matrix[column]);
    std::swap(result[pivot], result[column]);
    for (std::size_t row = 0; row < order; ++row) {
      if (row == column) continue;
      const S multiplier = matrix[row][column] / matrix[column][column];
      for (std::size_t j = 0; j < order; ++j) {
        matrix[row][j] = matrix[row][j] - multiplier * matrix[column][j];
        result[row][j] = result[row][j] - multiplier * result[column][j];
      }
    }
  }
  for (std::size_t row = 0; row < order; ++row) {
    for (S& entry : result[row]) entry = entry / matrix[row][row];
  }
  if (!is_bounded(result)) return std::nullopt;
  return middle(result);
}

template <class S>
S frobenius_norm(const Matrix<S>& matrix) {
  S sum(0);
  for (const auto& row : matrix) {
    for (const S& entry : row) sum = sum + square(entry);
  }
  return square_root(sum);
}

/// An upper bound of ‖QᵀQ − I‖.
template <class S>
S defect_of_orthogonality(const Matrix<S>& matrix) {
  const std::size_t order = matrix.size();
  auto product = zero_matrix<S>(order);
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = 0; j < order; ++j) {
      for (std::size_t row = 0; row < order; ++row) {
        product[i][j] = product[i][j] + matrix[row][i] * matrix[row][j];
      }
    }
    product[i][i] = product[i][i] - S(1);
  }
  return frobenius_norm(product);
}

/// A matrix near the polar factor of the given one, by Newton's iteration with Higham's scaling. No error bounds;
/// nothing if it did not come near an orthogonal matrix.
template <class S>
std::optional<Matrix<S>> approximate_polar_factor(Matrix<S> matrix) {
  constexpr int most_steps = 60;
  const std::size_t order = matrix.size();
  const S close = scalar_from<S>(Rational::power_of_two(16 - precision_bits<S>()));
  const S nearly = scalar_from<S>(Rational::power_of_two(-3));
  bool regularised = false;
  for (int step = 0; step < most_steps; ++step) {
    const S defect = defect_of_orthogonality(matrix);
    if (!is_bounded(defect)) return std::nullopt;
    if (is_proved(less(defect, close))) return matrix;
    auto inverse = approximate_inverse(matrix);
    if (!inverse) {
      // A degenerate image: any nearby regular matrix will do, what it is for is checked afterwards.
      if (regularised) return std::nullopt;
      regularised = true;
      const S shift =
          middle(S(frobenius_norm(matrix) * scalar_from<S>(Rational::power_of_two(-precision_bits<S>() / 2))));
      for (std::size_t i = 0; i < order; ++i) matrix[i][i] = middle(S(matrix[i][i] + shift));
      continue;
    }
    S scale(1);
    if (!is_proved(less(defect, nearly))) {
      scale = middle(square_root(S(frobenius_norm(*inverse) / frobenius_norm(matrix))));
      if (!is_refuted(is_zero(scale)) || !is_bounded(scale)) return std::nullopt;
    }
    Matrix<S> next = matrix;
    for (std::size_t i = 0; i < order; ++i) {
      for (std::size_t j = 0; j < order; ++j) {
        next[i][j] = middle(S((scale * matrix[i][j] + (*inverse)[j][i] / scale) / S(2)));
      }
    }
    matrix = std::move(next);
  }
  return is_proved(less(defect_of_orthogonality(matrix), nearly)) ? std::optional(matrix) : std::nullopt;
}

template <class S>
Matrix<S> product(const Matrix<S>& a, const Matrix<S>& b) {
  auto result = zero_matrix<S>(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < a.size(); ++j) {
      for (std::size_t at = 0; at < a.size(); ++at) result[i][j] = result[i][j] + a[i][at] * b[at][j];
    }
  }
  return result;
}

template <class S>
std::vector<S> squared_column_lengths(const Matrix<S>& matrix) {
  std::vector<S> result(matrix.size(), S(0));
  for (const auto& row : matrix) {
    for (std::size_t column = 0; column < row.size(); ++column) result[column] = result[column] + square(row[column]);
  }
  return result;
}

/// Whether λI − A is semidefinite.
template <class S>
bool is_norm_bound(const SymmetricMatrix<S>& matrix, const S& bound) {
  return is_proved(GramElimination<S>(matrix.negated().shifted(bound)).semidefinite());
}

/// A little more than the largest eigenvalue of a matrix near the given one. Without error bounds.
BigInterval approximate_norm_bound(const SymmetricMatrix<BigInterval>& matrix) {
  SymmetricMatrix<Rational> near(matrix.order());
  for (std::size_t i = 0; i < matrix.order(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) near(i, j) = matrix(i, j).lower();
  }
  const auto values = eigenvalues_by_scaling<BigInterval>(near);
  const Rational more = Rational(1) + Rational::power_of_two(-precision_bits<BigInterval>() / 2);
  return BigInterval((*values)[0].upper() * more);
}

/// An upper bound of ‖D‖, at most 1 % above it where the rung is sharp enough, far less on the higher ones: between the
/// longest column and the Frobenius norm, by bisection with the test whether λI − DᵀD is semidefinite; there first for
/// a λ of which it is likely.
template <class S>
S norm_from_above(const Matrix<S>& matrix) {
  const std::size_t order = matrix.size();
  SymmetricMatrix<S> gram(order);
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t row = 0; row < order; ++row) {
        gram(i, j) = gram(i, j) + (i == j ? square(matrix[row][i]) : matrix[row][i] * matrix[row][j]);
      }
    }
  }
  S least(0);
  S greatest(0);
  for (std::size_t i = 0; i < order; ++i) {
    least = maximum(least, gram(i, i));
    greatest = greatest + gram(i, i);
  }
  if (order == 1) return square_root(greatest);
  // Where 1 % does not decide, the precision rises.
  constexpr long quick_precision = 256;
  constexpr int steps = 10;
  if constexpr (std::same_as<S, BigInterval>) {
    if (precision_bits<S>() > quick_precision && is_bounded(greatest)) {
      const BigInterval likely = approximate_norm_bound(gram);
      if (is_norm_bound(gram, likely)) return square_root(likely);
    }
  }
  for (int step = 0; step < steps; ++step) {
    const S between = middle(S((least + greatest) / S(2)));
    (is_norm_bound(gram, between) ? greatest : least) = between;
  }
  return square_root(greatest);
}

template <class S>
S largest(const std::vector<S>& values) {
  S result = values.front();
  for (const S& value : values) result = maximum(result, value);
  return result;
}

/// From below: no isometry changes lengths and singular values.
template <class S>
Alignment<S> least_errors(Evaluation<S>& evaluation, const SimplexObject& simplex, const SimplexObject& image) {
  S by_lengths(0);
  for (std::size_t i = 1; i < simplex.vertex_count(); ++i) {
    const S difference = square_root(image.gram(evaluation).squared_edge(i, 0)) -
                         square_root(simplex.gram(evaluation).squared_edge(i, 0));
    by_lengths = maximum(by_lengths, absolute(difference));
  }
  S by_values = by_lengths;
  const auto before = eigenvalues_by_scaling<S>(simplex.exact_gram().gram());
  const auto after = eigenvalues_by_scaling<S>(image.exact_gram().gram());
  if (before && after) {
    for (std::size_t j = 0; j < before->size(); ++j) {
      by_values = maximum(by_values, absolute(S(square_root((*after)[j]) - square_root((*before)[j]))));
    }
  }
  return {by_values, by_lengths};
}

bool are_congruent(const SimplexObject& simplex, const SimplexObject& image) {
  for (std::size_t i = 0; i < simplex.vertex_count(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (simplex.exact_gram().squared_edge(i, j) != image.exact_gram().squared_edge(i, j)) return false;
    }
  }
  return true;
}

template <class S>
Partial<Alignment<S>> enclosed_alignment(Evaluation<S>& evaluation, const SimplexObject& simplex,
                                         const SimplexObject& image) {
  if (are_congruent(simplex, image)) return Alignment<S>{S(0), S(0)};
  auto undecided = Partial<Alignment<S>>::absent(Verdict::undecided);
  const auto before = triangular_factor(evaluation, simplex);
  const auto after = triangular_factor(evaluation, image);
  if (!before || !after || !is_bounded(*before) || !is_bounded(*after)) return undecided;
  const auto quotient_matrix = quotient(*after, *before);
  if (!is_bounded(quotient_matrix)) return undecided;
  const auto near_isometry = approximate_polar_factor(quotient_matrix);
  if (!near_isometry) return undecided;
  const S defect = defect_of_orthogonality(*near_isometry);
  // Else there may be no polar factor nearby.
  if (!is_proved(less(defect, S(1)))) return undecided;

  Matrix<S> difference = product(*near_isometry, *before);
  for (std::size_t i = 0; i < difference.size(); ++i) {
    for (std::size_t j = 0; j < difference.size(); ++j) difference[i][j] = (*after)[i][j] - difference[i][j];
  }
  const S matrix_error = norm_from_above(difference) + defect * frobenius_norm(*before);
  std::vector<S> vertex_errors;
  const auto moved = squared_column_lengths(difference);
  const auto lengths = squared_column_lengths(*before);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    vertex_errors.push_back(square_root(moved[i]) + defect * square_root(lengths[i]));
  }
  const Alignment<S> least = least_errors(evaluation, simplex, image);
  return Alignment<S>{joined(below(least.matrix_error), matrix_error),
                      joined(below(least.vertex_error), largest(vertex_errors))};
}

}  // namespace

template <>
Partial<Alignment<Interval>> alignment(Evaluation<Interval>& evaluation, const SimplexObject& simplex,
                                       const SimplexObject& image) {
  return enclosed_alignment(evaluation, simplex, image);
}

template <>
Partial<Alignment<BigInterval>> alignment(Evaluation<BigInterval>& evaluation, const SimplexObject& simplex,
                                          const SimplexObject& image) {
  return enclosed_alignment(evaluation, simplex, image);
}

template <>
Partial<Alignment<Algebraic>> alignment(Evaluation<Algebraic>& evaluation, const SimplexObject& simplex,
                                        const SimplexObject& image) {
  if (are_congruent(simplex, image)) return Alignment<Algebraic>{0, 0};
  if (simplex.dimension() != 1) return Partial<Alignment<Algebraic>>::absent(Verdict::undecided);
  return least_errors(evaluation, simplex, image);
}

}  // namespace delcert
