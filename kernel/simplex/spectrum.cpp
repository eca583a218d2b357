#include "kernel/simplex/spectrum.hpp"

#include <flint/fmpq_mat.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/number/flint_rational.hpp"
#include "kernel/number/nearest_rounding.hpp"
#include "kernel/simplex/inertia.hpp"
#include "kernel/simplex/real_rooted.hpp"

namespace delcert {

namespace {

// Small enough for the stack.
constexpr int largest_quick_order = 8;
using Approximation =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, largest_quick_order, largest_quick_order>;

/// Never inlined, so that no operation of it is moved out of the rounding mode that it expects, and none of ours into
/// it.
template <class Matrix>
[[gnu::noinline]] std::optional<Approximation> solved(const Approximation& matrix) {
  const NearestRounding nearest_rounding;
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(Matrix(matrix), Eigen::EigenvaluesOnly);
  if (solver.info() != Eigen::Success) return std::nullopt;
  return Approximation(solver.eigenvalues());
}

/// Without error bounds; nothing if Eigen's iteration does not end. The most usual orders are known to the compiler.
std::optional<Approximation> approximate_eigenvalues(const Approximation& matrix) {
  switch (matrix.rows()) {
    case 2:
      return solved<Eigen::Matrix2d>(matrix);
    case 3:
      return solved<Eigen::Matrix3d>(matrix);
    default:
      return solved<Approximation>(matrix);
  }
}

/// By a formula, much quicker; mostly as good, but not where two of them nearly coincide. As above.
[[gnu::noinline]] std::optional<Approximation> approximate_eigenvalues_by_formula(const Approximation& matrix) {
  if (matrix.rows() != 3) return std::nullopt;
  const NearestRounding nearest_rounding;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(Eigen::Matrix3d(matrix), Eigen::EigenvaluesOnly);
  if (!solver.eigenvalues().allFinite()) return std::nullopt;
  return Approximation(solver.eigenvalues());
}

/// Eigenvalues of one matrix proved on intervals, around approximations in doubles.
class IntervalSpectrum {
 public:
  explicit IntervalSpectrum(const SymmetricMatrix<Rational>& matrix) : matrix_(matrix_from<Interval>(matrix)) {
    const std::size_t order = matrix.order();
    if (order > largest_quick_order) return;
    Approximation entries(order, order);
    for (std::size_t row = 0; row < order; ++row) {
      for (std::size_t column = 0; column < order; ++column) {
        const double entry = matrix_(row, column).upper();
        if (!std::isfinite(entry)) return;
        entries(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = entry;
      }
    }
    by_formula_ = approximate_eigenvalues_by_formula(entries);
    entries_ = entries;
  }

  /// An enclosure of the eigenvalue of this index, the largest first, if one was proved.
  [[nodiscard]] std::optional<Interval> at(std::size_t index) {
    if (matrix_.order() == 1) return matrix_(0, 0);
    if (by_formula_) {
      if (const auto around = proved_around(*by_formula_, index, 0x1p-44)) return around;
    }
    if (entries_ && !iterated_) iterated_ = approximate_eigenvalues(*entries_);
    return iterated_ ? proved_around(*iterated_, index, 0x1p-30) : std::nullopt;
  }

 private:
  /// The narrowest interval around the approximation, up to this relative width, in which the eigenvalue is proved to
  /// be.
  [[nodiscard]] std::optional<Interval> proved_around(const Approximation& ascending, std::size_t index,
                                                      double widest) const {
    const Interval near = Interval::exactly(ascending(static_cast<Eigen::Index>(matrix_.order() - 1 - index)));
    const double size = ascending.cwiseAbs().maxCoeff();
    for (double width = 0x1p-48 * size; width < widest * size; width *= 0x1p4) {
      const Interval around = near + Interval::between(-width, width);
      if (is_proved_in(around, index)) return around;
    }
    return std::nullopt;
  }

  /// By the inertia.
  [[nodiscard]] bool is_proved_in(const Interval& around, std::size_t index) const {
    const auto above = inertia(matrix_.shifted(-Interval::exactly(around.lower())));
    if (!above || above->positive < index + 1) return false;
    const auto below = inertia(matrix_.shifted(-Interval::exactly(around.upper())));
    return below && below->negative >= matrix_.order() - index;
  }

  SymmetricMatrix<Interval> matrix_;
  std::optional<Approximation> entries_;
  std::optional<Approximation> by_formula_;
  std::optional<Approximation> iterated_;
};

/// A multiple with integral coefficients of the polynomial with these rational ones.
class IntegralPolynomial {
 public:
  explicit IntegralPolynomial(const std::vector<Rational>& coefficients) {
    fmpq_poly_t rational;
    fmpq_poly_init(rational);
    for (std::size_t power = 0; power < coefficients.size(); ++power)
      set_coefficient(rational, static_cast<slong>(power), coefficients[power]);
    fmpz_poly_init(value_);
    fmpq_poly_get_numerator(value_, rational);
    fmpq_poly_clear(rational);
  }
  IntegralPolynomial(const IntegralPolynomial&) = delete;
  IntegralPolynomial& operator=(const IntegralPolynomial&) = delete;
  ~IntegralPolynomial() { fmpz_poly_clear(value_); }
  [[nodiscard]] const fmpz_poly_struct* get() const { return value_; }

 private:
  fmpz_poly_t value_;
};

std::vector<Integer> coefficients_of(const fmpz_poly_struct* polynomial) {
  std::vector<Integer> result(static_cast<std::size_t>(fmpz_poly_degree(polynomial)) + 1);
  for (std::size_t power = 0; power < result.size(); ++power) {
    fmpz_get_mpz(result[power].backend().data(), fmpz_poly_get_coeff_ptr(polynomial, static_cast<slong>(power)));
  }
  return result;
}

/// A matrix of integers times a unit near a rational one.
struct IntegralMatrix {
  SymmetricMatrix<Rational> entries;  ///< integers
  long unit_exponent = 0;             ///< the unit is 2 to it
  Rational margin = Rational(0);      ///< how far eigenvalues are from those of the rational matrix, at most
  Integer greatest_eigenvalue = 0;    ///< an upper bound of their sizes, in units
};

/// Precondition: the matrix is not 0.
IntegralMatrix rounded_to_working_precision(const SymmetricMatrix<Rational>& matrix) {
  constexpr long spare_bits = 16;
  Rational greatest(0);
  for (std::size_t i = 0; i < matrix.order(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) greatest = maximum(greatest, absolute(matrix(i, j)));
  }
  IntegralMatrix result{matrix};
  result.unit_exponent =
      binary_exponent(greatest) - static_cast<long>(BigInterval::working_precision().value) - spare_bits;
  const Rational unit = Rational::power_of_two(result.unit_exponent);
  Rational farthest(0);
  Rational largest(0);
  for (std::size_t i = 0; i < matrix.order(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const Rational rounded = rounded_down(matrix(i, j), result.unit_exponent);
      farthest = maximum(farthest, matrix(i, j) - rounded);
      result.entries(i, j) = rounded / unit;
      largest = maximum(largest, absolute(result.entries(i, j)));
    }
  }
  // The norm of a matrix is at most its order times its largest entry.
  const Rational order(static_cast<long>(matrix.order()));
  result.margin = farthest * order;
  result.greatest_eigenvalue = (largest * order).numerator();
  return result;
}

/// The eigenvalues of an integral matrix, in any order.
std::vector<BigInterval> eigenvalues_of(const IntegralMatrix& matrix) {
  const IntegralPolynomial polynomial(characteristic_polynomial(matrix.entries));
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor_squarefree(factors, polynomial.get());
  std::vector<BigInterval> result;
  for (slong at = 0; at < factors->num; ++at) {
    const std::vector<Integer> coefficients = coefficients_of(factors->p + at);
    auto roots = separated_roots(coefficients);
    if (!roots) roots = located_roots(coefficients, matrix.greatest_eigenvalue);
    for (slong time = 0; time < factors->exp[at]; ++time) result.insert(result.end(), roots->begin(), roots->end());
  }
  fmpz_poly_factor_clear(factors);
  return result;
}

}  // namespace

std::vector<Rational> characteristic_polynomial(const SymmetricMatrix<Rational>& matrix) {
  const auto order = static_cast<slong>(matrix.order());
  fmpq_mat_t entries;
  fmpq_mat_init(entries, order, order);
  for (slong row = 0; row < order; ++row) {
    for (slong column = 0; column < order; ++column) {
      fmpq_set_mpq(fmpq_mat_entry(entries, row, column),
                   matrix(static_cast<std::size_t>(row), static_cast<std::size_t>(column)).gmp());
    }
  }
  fmpq_poly_t polynomial;
  fmpq_poly_init(polynomial);
  fmpq_mat_charpoly(polynomial, entries);
  fmpq_mat_clear(entries);
  std::vector<Rational> result;
  for (slong power = 0; power <= order; ++power) result.push_back(coefficient_of(polynomial, power));
  fmpq_poly_clear(polynomial);
  return result;
}

template <>
Partial<std::vector<Interval>> eigenvalues<Interval>(const SymmetricMatrix<Rational>& matrix) {
  IntervalSpectrum spectrum(matrix);
  std::vector<Interval> result;
  for (std::size_t index = 0; index < matrix.order(); ++index) {
    const auto proved = spectrum.at(index);
    if (!proved) return Partial<std::vector<Interval>>::absent(Verdict::undecided);
    result.push_back(*proved);
  }
  return result;
}

template <>
Partial<Interval> eigenvalue<Interval>(const SymmetricMatrix<Rational>& matrix, std::size_t index) {
  const auto proved = IntervalSpectrum(matrix).at(index);
  return proved ? Partial<Interval>(*proved) : Partial<Interval>::absent(Verdict::undecided);
}

template <>
Partial<std::vector<BigInterval>> eigenvalues<BigInterval>(const SymmetricMatrix<Rational>& matrix) {
  Rational unit(1);
  Rational margin(0);
  std::vector<BigInterval> result;
  const IntegralPolynomial polynomial(characteristic_polynomial(matrix));
  if (auto separated = separated_roots(coefficients_of(polynomial.get()))) {
    result = *std::move(separated);
  } else {
    // Eigenvalues that nearly coincide would take thousands of digits to tell apart.
    const IntegralMatrix near = rounded_to_working_precision(matrix);
    unit = Rational::power_of_two(near.unit_exponent);
    margin = near.margin;
    result = eigenvalues_of(near);
  }
  // Enclosures of different roots may overlap at a low precision: then the order of their lower ends and that of their
  // upper ends each enclose the sorted roots.
  std::vector<Rational> lower;
  std::vector<Rational> upper;
  for (const BigInterval& root : result) {
    lower.push_back(root.lower() * unit - margin);
    upper.push_back(root.upper() * unit + margin);
  }
  std::sort(lower.begin(), lower.end());
  std::sort(upper.begin(), upper.end());
  const std::size_t order = result.size();
  for (std::size_t at = 0; at < order; ++at) {
    result[at] = BigInterval::between(lower[order - 1 - at], upper[order - 1 - at]);
  }
  return result;
}

template <>
Partial<std::vector<Surd>> eigenvalues<Surd>(const SymmetricMatrix<Rational>& matrix) {
  if (matrix.order() > 1) return Partial<std::vector<Surd>>::absent(Verdict::undecided);
  if (matrix.order() == 0) return std::vector<Surd>{};
  return std::vector<Surd>{Surd(matrix(0, 0))};
}

template <>
Partial<std::vector<Algebraic>> eigenvalues<Algebraic>(const SymmetricMatrix<Rational>& matrix) {
  std::vector<Algebraic> result = real_roots(characteristic_polynomial(matrix));
  std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace delcert
