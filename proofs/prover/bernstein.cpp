#include "proofs/prover/bernstein.hpp"

#include <flint/fmpz_vec.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace delcert {

namespace {

/// An integer of FLINT with an end to its life.
class FlintInteger {
 public:
  FlintInteger() { fmpz_init(value_); }
  explicit FlintInteger(const Integer& x) : FlintInteger() { fmpz_set_mpz(value_, x.backend().data()); }
  FlintInteger(const FlintInteger&) = delete;
  FlintInteger& operator=(const FlintInteger&) = delete;
  ~FlintInteger() { fmpz_clear(value_); }
  fmpz* raw() { return value_; }

 private:
  fmpz_t value_;
};

std::size_t size_of(const std::vector<unsigned long>& degrees, std::size_t most) {
  std::size_t size = 1;
  for (const unsigned long degree : degrees) {
    if (degree >= most || size > most / (degree + 1)) throw std::length_error("too many Bernstein coefficients");
    size *= degree + 1;
  }
  return size;
}

/// The coefficients of p(scale_0 + scale_1 u)·denominator^d along a line of coefficients of p, by Horner's rule.
void substitute_line(FlintIntegers& line, fmpz* constant, fmpz* slope, fmpz* denominator) {
  const std::size_t degree = line.size() - 1;
  FlintIntegers result(line.size());
  FlintInteger scale;
  fmpz_one(scale.raw());
  FlintInteger product;
  for (std::size_t step = 0; step <= degree; ++step) {
    const std::size_t at = degree - step;
    // result := result·(constant + slope·u) + line[at]·denominator^step
    for (std::size_t i = step + 1; i-- > 0;) {
      fmpz_mul(product.raw(), result.at(i), constant);
      if (i > 0) fmpz_addmul(product.raw(), result.at(i - 1), slope);
      fmpz_set(result.at(i), product.raw());
    }
    fmpz_addmul(result.at(0), line.at(at), scale.raw());
    fmpz_mul(scale.raw(), scale.raw(), denominator);
  }
  line = std::move(result);
}

/// b_j = multiple/C(d, j)·line_j for the least common multiple of the binomial coefficients.
void divide_by_binomials(FlintIntegers& line) {
  const auto degree = static_cast<ulong>(line.size() - 1);
  FlintInteger multiple;
  FlintInteger binomial;
  fmpz_one(multiple.raw());
  for (ulong j = 0; j <= degree; ++j) {
    fmpz_bin_uiui(binomial.raw(), degree, j);
    fmpz_lcm(multiple.raw(), multiple.raw(), binomial.raw());
  }
  for (ulong j = 0; j <= degree; ++j) {
    fmpz_bin_uiui(binomial.raw(), degree, j);
    fmpz_divexact(binomial.raw(), multiple.raw(), binomial.raw());
    fmpz_mul(line.at(j), line.at(j), binomial.raw());
  }
}

/// From Σ c_i t^i to the coefficients of t^j (1 − t)^(d − j), which are Σ_{i <= j} C(d − i, j − i) c_i.
void to_scaled_bernstein(FlintIntegers& line) {
  const std::size_t degree = line.size() - 1;
  // Each t^i is multiplied by (t + (1 − t))^(degree − i).
  FlintIntegers result(line.size());
  FlintInteger binomial;
  for (std::size_t i = 0; i <= degree; ++i) {
    for (std::size_t j = i; j <= degree; ++j) {
      fmpz_bin_uiui(binomial.raw(), degree - i, j - i);
      fmpz_addmul(result.at(j), line.at(i), binomial.raw());
    }
  }
  line = std::move(result);
}

void reverse(FlintIntegers& line) {
  for (std::size_t i = 0, j = line.size() - 1; i < j; ++i, --j) fmpz_swap(line.at(i), line.at(j));
}

/// A fraction a/q as integers.
struct Fraction {
  explicit Fraction(const Rational& x) : numerator(x.numerator()), denominator(x.denominator()) {}
  FlintInteger numerator;
  FlintInteger denominator;
};

}  // namespace

std::string_view name_of(Sign sign) {
  switch (sign) {
    case Sign::negative:
      return "negative";
    case Sign::nonpositive:
      return "nonpositive";
    case Sign::zero:
      return "zero";
    case Sign::nonnegative:
      return "nonnegative";
    case Sign::positive:
      return "positive";
    default:
      return "unknown";
  }
}

Sign opposite(Sign sign) {
  switch (sign) {
    case Sign::negative:
      return Sign::positive;
    case Sign::nonpositive:
      return Sign::nonnegative;
    case Sign::nonnegative:
      return Sign::nonpositive;
    case Sign::positive:
      return Sign::negative;
    default:
      return sign;
  }
}

Sign product(Sign a, Sign b) {
  if (a == Sign::zero || b == Sign::zero) return Sign::zero;
  if (a == Sign::unknown || b == Sign::unknown) return Sign::unknown;
  const bool negative =
      (a == Sign::negative || a == Sign::nonpositive) != (b == Sign::negative || b == Sign::nonpositive);
  const Sign size = is_strict(a) && is_strict(b) ? Sign::positive : Sign::nonnegative;
  return negative ? opposite(size) : size;
}

Sign even_power(Sign sign) { return sign == Sign::unknown ? Sign::nonnegative : product(sign, sign); }

std::optional<Rational> UnitMap::at(const Rational& t) const {
  if (lower && upper) return *lower + t * (*upper - *lower);
  if (lower) {
    if (t == Rational(1)) return std::nullopt;
    return *lower + t / (Rational(1) - t);
  }
  if (t == Rational(0)) return std::nullopt;
  return *upper - (Rational(1) - t) / t;
}

Rational UnitMap::inverse(const Rational& y) const {
  if (lower && upper) return *lower == *upper ? Rational(0) : (y - *lower) / (*upper - *lower);
  if (lower) return (y - *lower) / (y - *lower + Rational(1));
  return Rational(1) / (*upper - y + Rational(1));
}

FlintIntegers::FlintIntegers(std::size_t size) : values_(_fmpz_vec_init(static_cast<slong>(size))), size_(size) {}

FlintIntegers::FlintIntegers(const FlintIntegers& other) : FlintIntegers(other.size_) {
  _fmpz_vec_set(values_, other.values_, static_cast<slong>(size_));
}

FlintIntegers::FlintIntegers(FlintIntegers&& other) noexcept
    : values_(std::exchange(other.values_, nullptr)), size_(std::exchange(other.size_, 0)) {}

FlintIntegers& FlintIntegers::operator=(FlintIntegers other) noexcept {
  std::swap(values_, other.values_);
  std::swap(size_, other.size_);
  return *this;
}

FlintIntegers::~FlintIntegers() {
  if (values_ != nullptr) _fmpz_vec_clear(values_, static_cast<slong>(size_));
}

std::size_t BernsteinTensor::stride(std::size_t variable) const {
  std::size_t result = 1;
  for (std::size_t i = variable + 1; i < degrees_.size(); ++i) result *= degrees_[i] + 1;
  return result;
}

template <class Change>
void BernsteinTensor::for_each_line(std::size_t variable, const Change& change) {
  const std::size_t length = degrees_[variable] + 1;
  const std::size_t step = stride(variable);
  FlintIntegers line(length);
  for (std::size_t block = 0; block < coefficients_.size(); block += step * length) {
    for (std::size_t begin = block; begin < block + step; ++begin) {
      for (std::size_t i = 0; i < length; ++i) fmpz_swap(line.at(i), coefficients_.at(begin + i * step));
      change(line);
      for (std::size_t i = 0; i < length; ++i) fmpz_swap(line.at(i), coefficients_.at(begin + i * step));
    }
  }
}

BernsteinTensor::BernsteinTensor(const Polynomial& p, const std::vector<UnitMap>& box, std::size_t most)
    : degrees_(p.degrees()), coefficients_(size_of(degrees_, most)) {
  const auto terms = p.terms();
  Integer common = 1;
  for (const auto& term : terms) common = boost::multiprecision::lcm(common, term.coefficient.denominator());
  for (const auto& term : terms) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < degrees_.size(); ++i) at = at * (degrees_[i] + 1) + term.exponents[i];
    FlintInteger value((term.coefficient * Rational(common)).numerator());
    fmpz_set(coefficients_.at(at), value.raw());
  }
  for (std::size_t i = 0; i < degrees_.size(); ++i) {
    if (degrees_[i] > 0) map_to_unit(i, box[i]);
  }
  remove_content();
}

void BernsteinTensor::map_to_unit(std::size_t variable, const UnitMap& map) {
  const bool bounded = map.lower && map.upper;
  const bool reversed = !map.lower;
  const Rational origin = reversed ? *map.upper : *map.lower;
  const Rational width = bounded ? *map.upper - *map.lower : Rational(reversed ? -1 : 1);
  // y = (a + b u)/q
  Fraction a(origin);
  Fraction b(width);
  FlintInteger constant;
  FlintInteger slope;
  FlintInteger denominator;
  fmpz_mul(constant.raw(), a.numerator.raw(), b.denominator.raw());
  fmpz_mul(slope.raw(), b.numerator.raw(), a.denominator.raw());
  fmpz_mul(denominator.raw(), a.denominator.raw(), b.denominator.raw());
  for_each_line(variable, [&](FlintIntegers& line) {
    substitute_line(line, constant.raw(), slope.raw(), denominator.raw());
    if (bounded) to_scaled_bernstein(line);
    divide_by_binomials(line);
    if (reversed) reverse(line);
  });
}

void BernsteinTensor::remove_content() {
  FlintInteger content;
  _fmpz_vec_content(content.raw(), coefficients_.at(0), static_cast<slong>(coefficients_.size()));
  if (fmpz_cmp_ui(content.raw(), 1) > 0) {
    _fmpz_vec_scalar_divexact_fmpz(coefficients_.at(0), coefficients_.at(0), static_cast<slong>(coefficients_.size()),
                                   content.raw());
  }
}

/// De Casteljau's scheme without divisions: at = p/q, row r is multiplied by q^r.
void BernsteinTensor::subdivide(std::size_t variable, const Rational& at, bool left) {
  const std::size_t degree = degrees_[variable];
  if (degree == 0) return;
  Fraction ratio(at);
  FlintInteger rest;
  fmpz_sub(rest.raw(), ratio.denominator.raw(), ratio.numerator.raw());
  FlintIntegers scales(degree + 1);
  fmpz_one(scales.at(0));
  for (std::size_t r = 1; r <= degree; ++r) fmpz_mul(scales.at(r), scales.at(r - 1), ratio.denominator.raw());
  for_each_line(variable, [&](FlintIntegers& line) {
    FlintIntegers result(degree + 1);
    for (std::size_t r = 0; r <= degree; ++r) {
      const std::size_t kept = left ? 0 : degree - r;
      fmpz_mul(result.at(left ? r : degree - r), line.at(kept), scales.at(degree - r));
      for (std::size_t i = 0; i + r < degree; ++i) {
        fmpz_mul(line.at(i), line.at(i), rest.raw());
        fmpz_addmul(line.at(i), line.at(i + 1), ratio.numerator.raw());
      }
    }
    line = std::move(result);
  });
  remove_content();
}

BernsteinTensor BernsteinTensor::left_of(std::size_t variable, const Rational& at) const {
  BernsteinTensor result = *this;
  result.subdivide(variable, at, true);
  return result;
}

BernsteinTensor BernsteinTensor::right_of(std::size_t variable, const Rational& at) const {
  BernsteinTensor result = *this;
  result.subdivide(variable, at, false);
  return result;
}

/// Of a face that belongs to the box, a smaller face that does has its coefficients among those of the greater one: it
/// is enough to look at the smallest, a corner but for the variables without any end.
bool BernsteinTensor::has_positive_on_minimal_faces(const std::vector<OpenEnds>& open, int sign) const {
  std::vector<bool> has(std::size_t{1} << degrees_.size(), false);
  std::vector<bool> wanted(has.size(), false);
  // The faces, as sets of variables that are at their upper end.
  for (std::size_t face = 0; face < has.size(); ++face) {
    bool exists = true;
    for (std::size_t i = 0; i < degrees_.size() && exists; ++i) {
      const bool upper = (face >> i & 1U) != 0;
      // Without an end that belongs to the box, "lower" stands for all coefficients.
      const bool none = (open[i].lower && open[i].upper) || degrees_[i] == 0;
      exists = none ? !upper : upper ? !open[i].upper : !open[i].lower;
    }
    wanted[face] = exists;
  }
  std::vector<unsigned long> index(degrees_.size(), 0);
  for (std::size_t at = 0; at < coefficients_.size(); ++at) {
    if (fmpz_sgn(coefficients_.at(at)) == sign) {
      for (std::size_t face = 0; face < has.size(); ++face) {
        if (!wanted[face] || has[face]) continue;
        bool belongs = true;
        for (std::size_t i = 0; i < degrees_.size() && belongs; ++i) {
          if ((open[i].lower && open[i].upper) || degrees_[i] == 0) continue;
          belongs = index[i] == ((face >> i & 1U) != 0 ? degrees_[i] : 0UL);
        }
        if (belongs) has[face] = true;
      }
    }
    for (std::size_t i = degrees_.size(); i-- > 0;) {
      if (++index[i] <= degrees_[i]) break;
      index[i] = 0;
    }
  }
  return std::equal(has.begin(), has.end(), wanted.begin(), [](bool h, bool w) { return h || !w; });
}

Sign BernsteinTensor::sign(const std::vector<OpenEnds>& open) const {
  bool has_positive = false;
  bool has_negative = false;
  for (std::size_t at = 0; at < coefficients_.size(); ++at) {
    const int sign = fmpz_sgn(coefficients_.at(at));
    has_positive = has_positive || sign > 0;
    has_negative = has_negative || sign < 0;
    if (has_positive && has_negative) return Sign::unknown;
  }
  if (has_positive) return has_positive_on_minimal_faces(open, 1) ? Sign::positive : Sign::nonnegative;
  if (has_negative) return has_positive_on_minimal_faces(open, -1) ? Sign::negative : Sign::nonpositive;
  return Sign::zero;
}

double BernsteinTensor::approximate_variation(std::size_t variable) const {
  if (degrees_[variable] == 0) return 0;
  const std::size_t step = stride(variable);
  const std::size_t length = degrees_[variable] + 1;
  // Relative to a common power of two, as the integers may be too large for doubles.
  ulong bits = 1;
  for (std::size_t at = 0; at < coefficients_.size(); ++at) bits = std::max(bits, fmpz_bits(coefficients_.at(at)));
  const auto value = [&](std::size_t at) {
    slong exponent = 0;
    const double mantissa = fmpz_get_d_2exp(&exponent, coefficients_.at(at));
    return std::ldexp(mantissa, static_cast<int>(std::max<slong>(exponent - static_cast<slong>(bits), -2000)));
  };
  double variation = 0;
  for (std::size_t block = 0; block < coefficients_.size(); block += step * length) {
    for (std::size_t begin = block; begin < block + step; ++begin) {
      for (std::size_t i = 0; i + 1 < length; ++i) {
        variation = std::max(variation, std::abs(value(begin + (i + 1) * step) - value(begin + i * step)));
      }
    }
  }
  return variation;
}

}  // namespace delcert
