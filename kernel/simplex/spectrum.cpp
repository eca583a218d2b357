#include "kernel/simplex/spectrum.hpp"

#include <flint/fmpq_mat.h>
#include <flint/fmpz_poly_factor.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <optional>

#include "kernel/number/nearest_rounding.hpp"
#include "kernel/simplex/bisection.hpp"
#include "kernel/simplex/inertia.hpp"

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

/// Eigenvalues of one matrix proved on intervals, around approximations in doubles.
class IntervalSpectrum {
 public:
  explicit IntervalSpectrum(const SymmetricMatrix<Rational>& matrix) : matrix_(matrix_from<Interval>(matrix)) {
    const std::size_t order = matrix.order();
    if (order > largest_quick_order) return;
    Approximation approximate(order, order);
    for (std::size_t row = 0; row < order; ++row) {
      for (std::size_t column = 0; column < order; ++column) {
        const double entry = matrix_(row, column).upper();
        if (!std::isfinite(entry)) return;
        approximate(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = entry;
      }
    }
    const auto values = approximate_eigenvalues(approximate);
    if (!values) return;
    for (std::size_t index = order; index-- > 0;) {
      approximate_.push_back((*values)(static_cast<Eigen::Index>(index)));
    }
    size_ = order == 0 ? 0 : values->cwiseAbs().maxCoeff();
  }

  /// An enclosure of the eigenvalue of this index, the largest first, if one was proved.
  [[nodiscard]] std::optional<Interval> at(std::size_t index) const {
    if (matrix_.order() == 1) return matrix_(0, 0);
    if (approximate_.empty()) return std::nullopt;
    for (double width = 0x1p-48 * size_; width < 0x1p-30 * size_; width *= 0x1p4) {
      if (const auto around = proved_around(index, width)) return around;
    }
    return std::nullopt;
  }

 private:
  /// [approximate − width, approximate + width] if the inertia proves that the eigenvalue is in it.
  [[nodiscard]] std::optional<Interval> proved_around(std::size_t index, double width) const {
    const Interval around = Interval::exactly(approximate_[index]) + Interval::between(-width, width);
    const auto above = inertia(matrix_.shifted(-Interval::exactly(around.lower())));
    if (!above || above->positive < index + 1) return std::nullopt;
    const auto below = inertia(matrix_.shifted(-Interval::exactly(around.upper())));
    if (!below || below->negative < matrix_.order() - index) return std::nullopt;
    return around;
  }

  SymmetricMatrix<Interval> matrix_;
  std::vector<double> approximate_;
  double size_ = 0;
};

using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<110, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// The sign at numerator·2^exponent of the polynomial with these coefficients, that of x⁰ first.
int sign_at(const std::vector<Integer>& coefficients, const Integer& numerator, long exponent) {
  // Times 2^(−exponent·degree), or not, so that everything is an integer.
  const auto down = static_cast<mp_bitcnt_t>(std::max(0L, -exponent));
  Integer x;
  mpz_mul_2exp(x.backend().data(), numerator.backend().data(), static_cast<mp_bitcnt_t>(std::max(0L, exponent)));
  const std::size_t degree = coefficients.size() - 1;
  Integer value;
  Integer term;
  for (std::size_t power = degree + 1; power-- > 0;) {
    mpz_mul_2exp(term.backend().data(), coefficients[power].backend().data(), down * (degree - power));
    value = value * x + term;
  }
  return mpz_sgn(value.backend().data());
}

/// A multiple with integral coefficients of the polynomial with these rational ones.
class IntegralPolynomial {
 public:
  explicit IntegralPolynomial(const std::vector<Rational>& coefficients) {
    fmpq_poly_t rational;
    fmpq_poly_init(rational);
    fmpq_t fraction;
    fmpq_init(fraction);
    for (std::size_t power = 0; power < coefficients.size(); ++power) {
      fmpq_set_mpq(fraction, coefficients[power].gmp());
      fmpq_poly_set_coeff_fmpq(rational, static_cast<slong>(power), fraction);
    }
    fmpq_clear(fraction);
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

/// The least root in size by Laguerre's method from 0, which converges where all roots are real; `known` are left out.
/// Without error bounds; nothing where it does not converge.
std::optional<Real> approximate_root(const std::vector<Real>& coefficients, const std::vector<Real>& known) {
  constexpr int most_steps = 100;
  const Real close = ldexp(Real(1), -290);
  const auto remaining = static_cast<int>(coefficients.size() - 1 - known.size());
  Real x(0);
  for (int step = 0; step < most_steps; ++step) {
    Real value(0);
    Real slope(0);
    Real half_bend(0);
    for (std::size_t at = coefficients.size(); at-- > 0;) {
      half_bend = half_bend * x + slope;
      slope = slope * x + value;
      value = value * x + coefficients[at];
    }
    if (value == 0) return x;
    Real first = slope / value;
    Real second = first * first - 2 * half_bend / value;
    for (const Real& root : known) {
      const Real inverse = 1 / (x - root);
      first -= inverse;
      second -= inverse * inverse;
    }
    const Real under_root = (remaining - 1) * (remaining * second - first * first);
    const Real root = under_root > 0 ? Real(sqrt(under_root)) : Real(0);
    const Real divisor = first > 0 ? Real(first + root) : Real(first - root);
    const Real change = remaining / divisor;
    if (!(boost::multiprecision::isfinite)(change)) return std::nullopt;
    x -= change;
    if (abs(change) <= abs(x) * close) return x;
  }
  return std::nullopt;
}

/// numerator·2^exponent
struct Dyadic {
  Integer numerator;
  long exponent = 0;
};

/// A number of any precision, for Newton's method.
class LongReal {
 public:
  explicit LongReal(long bits) { mpfr_init2(value_, bits); }
  LongReal(const LongReal&) = delete;
  LongReal& operator=(const LongReal&) = delete;
  ~LongReal() { mpfr_clear(value_); }
  [[nodiscard]] mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// The approximation of a simple root to so many bits, by Newton's method. Without error bounds.
Dyadic refined(const std::vector<Integer>& coefficients, const Real& root, long bits) {
  constexpr long known_bits = 200;
  const long working_bits = std::max(2 * known_bits, bits + 64);
  LongReal x(working_bits);
  LongReal value(working_bits);
  LongReal slope(working_bits);
  mpfr_set(x.get(), root.backend().data(), MPFR_RNDN);
  for (long correct = known_bits; correct < bits + 16; correct *= 2) {
    mpfr_set_zero(value.get(), 1);
    mpfr_set_zero(slope.get(), 1);
    for (std::size_t at = coefficients.size(); at-- > 0;) {
      mpfr_mul(slope.get(), slope.get(), x.get(), MPFR_RNDN);
      mpfr_add(slope.get(), slope.get(), value.get(), MPFR_RNDN);
      mpfr_mul(value.get(), value.get(), x.get(), MPFR_RNDN);
      mpfr_add_z(value.get(), value.get(), coefficients[at].backend().data(), MPFR_RNDN);
    }
    if (mpfr_zero_p(slope.get()) != 0) break;
    mpfr_div(value.get(), value.get(), slope.get(), MPFR_RNDN);
    mpfr_sub(x.get(), x.get(), value.get(), MPFR_RNDN);
  }
  mpfr_prec_round(x.get(), bits, MPFR_RNDN);
  if (mpfr_regular_p(x.get()) == 0) return {};
  Dyadic result;
  result.exponent = mpfr_get_z_2exp(result.numerator.backend().data(), x.get());
  return result;
}

/// Enclosures of the roots, by approximations and changes of sign: as many disjoint intervals as the degree, each with
/// a change of sign in it, hold one root each. Nothing where roots are too close to each other.
std::optional<std::vector<BigInterval>> separated_roots(const fmpz_poly_struct* polynomial) {
  const auto bits = static_cast<long>(BigInterval::working_precision().value);
  std::vector<Integer> exact;
  std::vector<Real> coefficients;
  for (slong power = 0; power <= fmpz_poly_degree(polynomial); ++power) {
    exact.emplace_back();
    fmpz_poly_get_coeff_mpz(exact.back().backend().data(), polynomial, power);
    coefficients.emplace_back(exact.back());
  }
  // Roots 0 are known.
  std::vector<BigInterval> result;
  while (exact.front() == 0) {
    exact.erase(exact.begin());
    coefficients.erase(coefficients.begin());
    result.emplace_back(0);
  }
  std::vector<Real> approximate;
  std::vector<RationalBounds> enclosures;
  while (approximate.size() + 1 < coefficients.size()) {
    const auto root = approximate_root(coefficients, approximate);
    if (!root || *root == 0) return std::nullopt;
    approximate.push_back(*root);
    const Dyadic near = refined(exact, *root, bits);
    if (near.numerator == 0) return std::nullopt;
    bool is_proved = false;
    for (long width = 2; width < bits / 2 && !is_proved; width += bits / 8) {
      const Integer margin = Integer(1) << static_cast<unsigned>(width);
      const Integer lower = near.numerator - margin;
      const Integer upper = near.numerator + margin;
      is_proved = sign_at(exact, lower, near.exponent) * sign_at(exact, upper, near.exponent) < 0;
      if (!is_proved) continue;
      const Rational unit = Rational::power_of_two(near.exponent);
      enclosures.push_back({Rational(lower) * unit, Rational(upper) * unit});
    }
    if (!is_proved) return std::nullopt;
  }
  std::sort(enclosures.begin(), enclosures.end(),
            [](const RationalBounds& a, const RationalBounds& b) { return a.lower < b.lower; });
  for (std::size_t at = 0; at < enclosures.size(); ++at) {
    if (at > 0 && enclosures[at].lower <= enclosures[at - 1].upper) return std::nullopt;
    result.push_back(BigInterval::between(enclosures[at].lower, enclosures[at].upper));
  }
  return result;
}

/// How many roots are greater than x, of a polynomial all of whose roots are real: as many as its Taylor coefficients
/// at x have changes of sign (Descartes' rule, which is exact then).
std::size_t count_above(std::vector<Integer> coefficients, const Integer& x) {
  for (std::size_t lowest = 0; lowest + 1 < coefficients.size(); ++lowest) {
    for (std::size_t at = coefficients.size() - 1; at-- > lowest;) {
      mpz_addmul(coefficients[at].backend().data(), x.backend().data(), coefficients[at + 1].backend().data());
    }
  }
  std::size_t changes = 0;
  int last = 0;
  for (const Integer& coefficient : coefficients) {
    const int sign = mpz_sgn(coefficient.backend().data());
    if (sign == 0) continue;
    if (last == -sign) ++changes;
    last = sign;
  }
  return changes;
}

/// Enclosures, by integers next to each other, of the roots of a polynomial all of whose roots are real and at most
/// `size` in size; by halving, so that it does not matter how close to each other they are.
std::vector<BigInterval> located_roots(const fmpz_poly_struct* polynomial, const Integer& size) {
  std::vector<Integer> coefficients;
  for (slong power = 0; power <= fmpz_poly_degree(polynomial); ++power) {
    coefficients.emplace_back();
    fmpz_poly_get_coeff_mpz(coefficients.back().backend().data(), polynomial, power);
  }
  // As many roots as the counts differ by are greater than the lower end, and not greater than the upper one.
  struct Range {
    Integer lower;
    Integer upper;
    std::size_t above_lower;
    std::size_t above_upper;
  };
  std::vector<BigInterval> result;
  std::vector<Range> ranges{{-size - 1, size, coefficients.size() - 1, 0}};
  while (!ranges.empty()) {
    const Range range = std::move(ranges.back());
    ranges.pop_back();
    const std::size_t inside = range.above_lower - range.above_upper;
    if (inside == 0) continue;
    if (range.upper - range.lower == 1) {
      result.insert(result.end(), inside, BigInterval::between(Rational(range.lower), Rational(range.upper)));
      continue;
    }
    Integer middle = range.lower + range.upper;
    mpz_fdiv_q_2exp(middle.backend().data(), middle.backend().data(), 1);
    const std::size_t above = count_above(coefficients, middle);
    ranges.push_back({range.lower, middle, range.above_lower, above});
    ranges.push_back({middle, range.upper, above, range.above_upper});
  }
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
    auto roots = separated_roots(factors->p + at);
    if (!roots) roots = located_roots(factors->p + at, matrix.greatest_eigenvalue);
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
  fmpq_t coefficient;
  fmpq_init(coefficient);
  for (slong power = 0; power <= order; ++power) {
    fmpq_poly_get_coeff_fmpq(coefficient, polynomial, power);
    Rational::Wrapped value;
    fmpq_get_mpq(value.backend().data(), coefficient);
    result.emplace_back(std::move(value));
  }
  fmpq_clear(coefficient);
  fmpq_poly_clear(polynomial);
  return result;
}

template <>
Partial<std::vector<Interval>> eigenvalues<Interval>(const SymmetricMatrix<Rational>& matrix) {
  const IntervalSpectrum spectrum(matrix);
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
  if (auto separated = separated_roots(IntegralPolynomial(characteristic_polynomial(matrix)).get())) {
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
