#include "proofs/replay/polynomial.hpp"

#include <flint/fmpq_mpoly_factor.h>

#include <algorithm>
#include <cstdlib>

namespace delcert::replay {

namespace {

/// C(n, k)
Number binomial(unsigned long n, unsigned long k) {
  Number result;
  fmpz_bin_uiui(fmpq_numref(result.raw()), n, k);
  return result;
}

/// floor or ceiling of the root to 64 binary digits after the point; exact if the root is rational.
Number root_bound(const Number& x, bool upper, bool& exact) {
  fmpz_t numerator;
  fmpz_t denominator;
  fmpz_init(numerator);
  fmpz_init(denominator);
  exact = fmpz_is_square(fmpq_numref(x.raw())) && fmpz_is_square(fmpq_denref(x.raw()));
  Number result;
  if (exact) {
    fmpz_sqrt(numerator, fmpq_numref(x.raw()));
    fmpz_sqrt(denominator, fmpq_denref(x.raw()));
  } else {
    // √(p/q) = √(pq 4^64)/(q 2^64)
    fmpz_mul(numerator, fmpq_numref(x.raw()), fmpq_denref(x.raw()));
    fmpz_mul_2exp(numerator, numerator, 128);
    fmpz_sqrt(numerator, numerator);
    if (upper) fmpz_add_ui(numerator, numerator, 1);
    fmpz_mul_2exp(denominator, fmpq_denref(x.raw()), 64);
  }
  fmpq_set_fmpz_frac(result.raw(), numerator, denominator);
  fmpz_clear(numerator);
  fmpz_clear(denominator);
  return result;
}

}  // namespace

Variables::Variables(std::vector<std::string> names) : names_(std::move(names)) {
  fmpq_mpoly_ctx_init(context_, std::max<slong>(1, static_cast<slong>(names_.size())), ORD_DEGLEX);
}

std::size_t Variables::index(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) throw Malformed("no parameter is called " + name);
  return static_cast<std::size_t>(found - names_.begin());
}

Polynomial::Polynomial(const Variables& variables, const Number& constant) : Polynomial(variables) {
  fmpq_mpoly_set_fmpq(value_, constant.raw(), variables.raw());
}

Polynomial::Polynomial(const Polynomial& other) : Polynomial(*other.variables_) {
  fmpq_mpoly_set(value_, other.value_, variables_->raw());
}

Polynomial::Polynomial(Polynomial&& other) noexcept : Polynomial(*other.variables_) {
  fmpq_mpoly_swap(value_, other.value_, variables_->raw());
}

Polynomial& Polynomial::operator=(Polynomial other) noexcept {
  fmpq_mpoly_swap(value_, other.value_, variables_->raw());
  return *this;
}

Polynomial Polynomial::variable(std::size_t index, const Variables& variables) {
  Polynomial result(variables);
  fmpq_mpoly_gen(result.value_, static_cast<slong>(index), variables.raw());
  return result;
}

Polynomial Polynomial::read(const std::string& text, const Variables& variables) {
  std::vector<const char*> names;
  for (const std::string& name : variables.names()) names.push_back(name.c_str());
  if (names.empty()) names.push_back("_");
  Polynomial result(variables);
  if (fmpq_mpoly_set_str_pretty(result.value_, text.c_str(), names.data(), variables.raw()) != 0) {
    throw Malformed("no polynomial: " + text);
  }
  return result;
}

std::optional<Number> Polynomial::constant() const {
  if (fmpq_mpoly_is_fmpq(value_, variables_->raw()) == 0) return std::nullopt;
  Number result;
  fmpq_mpoly_get_fmpq(result.raw(), value_, variables_->raw());
  return result;
}

bool Polynomial::has_integer_coefficients() const {
  Number coefficient;
  for (slong term = 0; term < fmpq_mpoly_length(value_, variables_->raw()); ++term) {
    fmpq_mpoly_get_term_coeff_fmpq(coefficient.raw(), value_, term, variables_->raw());
    if (!coefficient.is_integer()) return false;
  }
  return true;
}

bool Polynomial::depends_on(std::size_t variable) const {
  return fmpq_mpoly_degree_si(value_, static_cast<slong>(variable), variables_->raw()) > 0;
}

Polynomial Polynomial::power(unsigned long exponent) const {
  constexpr unsigned long greatest = 200000;
  Polynomial result(*variables_);
  if (exponent > greatest || fmpq_mpoly_pow_ui(result.value_, value_, exponent, variables_->raw()) == 0) {
    throw Rejected("a power that is too large");
  }
  return result;
}

std::optional<Polynomial> Polynomial::square_root() const {
  Polynomial result(*variables_);
  if (fmpq_mpoly_sqrt(result.value_, value_, variables_->raw()) == 0) return std::nullopt;
  return result;
}

std::optional<Polynomial> Polynomial::divided_by(const Polynomial& other) const {
  Polynomial result(*variables_);
  if (fmpq_mpoly_divides(result.value_, value_, other.value_, variables_->raw()) == 0) return std::nullopt;
  return result;
}

Polynomial Polynomial::common_divisor(const Polynomial& a, const Polynomial& b) {
  Polynomial result(*a.variables_);
  if (fmpq_mpoly_gcd(result.value_, a.value_, b.value_, a.variables_->raw()) == 0) return {*a.variables_, Number(1)};
  return result;
}

std::vector<std::pair<Polynomial, unsigned long>> Polynomial::factors(Number& constant) const {
  fmpq_mpoly_factor_t found;
  fmpq_mpoly_factor_init(found, variables_->raw());
  std::vector<std::pair<Polynomial, unsigned long>> result;
  const bool done = fmpq_mpoly_factor(found, value_, variables_->raw()) != 0;
  if (done) {
    fmpq_mpoly_factor_get_constant_fmpq(constant.raw(), found, variables_->raw());
    for (slong i = 0; i < fmpq_mpoly_factor_length(found, variables_->raw()); ++i) {
      Polynomial base(*variables_);
      fmpq_mpoly_factor_get_base(base.value_, found, i, variables_->raw());
      result.emplace_back(std::move(base),
                          static_cast<unsigned long>(fmpq_mpoly_factor_get_exp_si(found, i, variables_->raw())));
    }
  } else {
    constant = Number(1);
    result.emplace_back(*this, 1UL);
  }
  fmpq_mpoly_factor_clear(found, variables_->raw());
  return result;
}

/// The polynomial in t, where the variable is lower + (upper − lower) t, lower + t, or upper − t.
Polynomial Polynomial::shifted(const std::vector<Side>& sides) const {
  std::vector<Polynomial> images;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    const Number origin = side.lower ? *side.lower : *side.upper;
    const Number slope = side.lower && side.upper ? *side.upper - *side.lower : Number(side.lower ? 1 : -1);
    images.push_back(Polynomial(*variables_, origin) + Polynomial(*variables_, slope) * variable(i, *variables_));
  }
  if (images.empty()) return *this;
  std::vector<fmpq_mpoly_struct*> raw;
  for (Polynomial& image : images) raw.push_back(image.value_);
  Polynomial result(*variables_);
  if (fmpq_mpoly_compose_fmpq_mpoly(result.value_, value_, raw.data(), variables_->raw(), variables_->raw()) == 0) {
    throw Rejected("a polynomial that is too large to be shifted");
  }
  return result;
}

std::optional<int> Polynomial::sign_on(const std::vector<Side>& sides) const {
  if (const auto value = constant()) return 2 * value->sign();
  const Polynomial moved = shifted(sides);
  const std::size_t count = sides.size();
  std::vector<slong> degrees(count);
  fmpq_mpoly_degrees_si(degrees.data(), moved.value_, variables_->raw());
  std::size_t size = 1;
  for (slong& degree : degrees) {
    degree = std::max<slong>(degree, 0);
    size *= static_cast<std::size_t>(degree) + 1;
    if (size > 4000000) throw Rejected("too many coefficients");
  }
  std::vector<std::size_t> strides(count, 1);
  for (std::size_t i = count; i-- > 1;) strides[i - 1] = strides[i] * (static_cast<std::size_t>(degrees[i]) + 1);
  std::vector<Number> b(size);
  std::vector<ulong> exponents(std::max<std::size_t>(count, 1));
  for (slong term = 0; term < fmpq_mpoly_length(moved.value_, variables_->raw()); ++term) {
    fmpq_mpoly_get_term_exp_ui(exponents.data(), moved.value_, term, variables_->raw());
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i) at += exponents[i] * strides[i];
    fmpq_mpoly_get_term_coeff_fmpq(b[at].raw(), moved.value_, term, variables_->raw());
  }
  // Along each variable b_j = Σ_i C(j, i)/C(d, i) a_i; without upper end a_j/C(d, j), t being u/(1 − u) then.
  for (std::size_t i = 0; i < count; ++i) {
    const auto degree = static_cast<unsigned long>(degrees[i]);
    if (degree == 0) continue;
    const bool bounded = sides[i].lower && sides[i].upper;
    std::vector<Number> divided(degree + 1);
    for (std::size_t begin = 0; begin < size; ++begin) {
      if ((begin / strides[i]) % (degree + 1) != 0) continue;
      for (unsigned long j = 0; j <= degree; ++j) divided[j] = b[begin + j * strides[i]] / binomial(degree, j);
      for (unsigned long j = 0; j <= degree && bounded; ++j) {
        Number sum;
        for (unsigned long k = 0; k <= j; ++k) {
          if (divided[k].sign() != 0) sum = sum + binomial(j, k) * divided[k];
        }
        b[begin + j * strides[i]] = sum;
      }
      for (unsigned long j = 0; j <= degree && !bounded; ++j) b[begin + j * strides[i]] = divided[j];
    }
  }
  int sign = 0;
  for (const Number& coefficient : b) {
    const int here = coefficient.sign();
    if (here != 0 && sign != 0 && here != sign) return std::nullopt;
    if (here != 0) sign = here;
  }
  if (sign == 0) return 0;
  // Strict if each least face that belongs to the box has a coefficient that is not 0. At its first end a variable has
  // the index 0, at the other one its degree; the first end of u is the upper one if there is no lower one.
  std::vector<std::vector<slong>> faces{{}};
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<slong> choices;
    const bool from_above = !sides[i].lower;
    const bool first = from_above ? !sides[i].upper_open : !sides[i].lower_open;
    const bool last = !from_above && sides[i].upper && !sides[i].upper_open;
    if (degrees[i] > 0 && first) choices.push_back(0);
    if (degrees[i] > 0 && last) choices.push_back(degrees[i]);
    if (choices.empty()) choices.push_back(-1);
    std::vector<std::vector<slong>> longer;
    for (const auto& face : faces) {
      for (const slong choice : choices) {
        longer.push_back(face);
        longer.back().push_back(choice);
      }
    }
    faces = std::move(longer);
  }
  const bool strict = std::all_of(faces.begin(), faces.end(), [&](const std::vector<slong>& face) {
    for (std::size_t at = 0; at < size; ++at) {
      if (b[at].sign() == 0) continue;
      bool belongs = true;
      for (std::size_t i = 0; i < count && belongs; ++i) {
        const auto index = static_cast<slong>(at / strides[i] % (static_cast<std::size_t>(degrees[i]) + 1));
        belongs = face[i] < 0 || face[i] == index;
      }
      if (belongs) return true;
    }
    return false;
  });
  return strict ? 2 * sign : sign;
}

Side variable_side(const Side& parameter) {
  if (!parameter.is_squared) return parameter;
  if (!parameter.lower || parameter.lower->sign() < 0) throw Rejected("a squared parameter that may be negative");
  Side result = parameter;
  bool exact = false;
  result.lower = root_bound(*parameter.lower, false, exact);
  result.lower_open = parameter.lower_open || !exact;
  if (parameter.upper) {
    result.upper = root_bound(*parameter.upper, true, exact);
    result.upper_open = parameter.upper_open || !exact;
  }
  return result;
}

FractionReader::FractionReader(const Variables& variables, const std::vector<std::vector<Side>>& boxes)
    : variables_(variables), boxes_(boxes) {}

Fraction FractionReader::reduced(const Polynomial& numerator, const Polynomial& denominator) const {
  const Polynomial common = Polynomial::common_divisor(numerator, denominator);
  return {*numerator.divided_by(common), *denominator.divided_by(common)};
}

/// 1 if p is never negative, −1 if never positive. Throws Rejected if that is not seen.
int FractionReader::sign(const Polynomial& p) const {
  if (p.is_zero()) return 1;
  Number constant;
  const auto factors = p.factors(constant);
  int result = constant.sign();
  for (const auto& [base, exponent] : factors) {
    if (exponent % 2 == 0) continue;
    int common = 0;
    for (const auto& box : boxes_) {
      std::vector<Side> sides;
      for (const Side& side : box) sides.push_back(variable_side(side));
      const auto here = base.sign_on(sides);
      if (!here || common * *here < 0) throw Rejected("a root or an extreme of unknown sign");
      if (*here != 0) common = *here > 0 ? 1 : -1;
    }
    result *= common == 0 ? 1 : common;
  }
  return result;
}

Fraction FractionReader::quotient(const Fraction& a, const Fraction& b) {
  if (b.numerator.is_zero()) throw Rejected("a division by 0");
  divisors.push_back(b.numerator);
  return reduced(a.numerator * b.denominator, a.denominator * b.numerator);
}

Fraction FractionReader::root(const Fraction& a) {
  if (a.numerator.is_zero()) return a;
  const auto radical = (a.numerator * a.denominator).square_root();
  if (!radical) throw Rejected("a root of what is no square");
  const Polynomial plus(variables_, Number(1));
  const Polynomial minus(variables_, Number(-1));
  return reduced(*radical * (sign(*radical) < 0 ? minus : plus),
                 a.denominator * (sign(a.denominator) < 0 ? minus : plus));
}

Fraction FractionReader::power(const Fraction& base, const Number& exponent) {
  Number twice = exponent + exponent;
  if (!twice.is_integer()) throw Rejected("an exponent that is no integer and no half of one");
  const Fraction radical = exponent.is_integer() ? base : root(base);
  const Number whole = exponent.is_integer() ? exponent : twice;
  if (fmpz_bits(fmpq_numref(whole.raw())) > 30) throw Rejected("a power that is too large");
  const slong size = fmpz_get_si(fmpq_numref(whole.raw()));
  const auto count = static_cast<unsigned long>(std::labs(size));
  Fraction result{radical.numerator.power(count), radical.denominator.power(count)};
  if (size >= 0) return result;
  if (radical.numerator.is_zero()) throw Rejected("a division by 0");
  divisors.push_back(radical.numerator);
  return {result.denominator, result.numerator};
}

Fraction FractionReader::extreme(const Node& term) {
  Fraction best = read(*term.parts[0]);
  for (std::size_t i = 1; i < term.parts.size(); ++i) {
    const Fraction next = read(*term.parts[i]);
    const Fraction difference = reduced(next.numerator * best.denominator - best.numerator * next.denominator,
                                        next.denominator * best.denominator);
    if ((sign(difference) > 0) == (term.head == "max")) best = next;
  }
  return best;
}

Fraction FractionReader::read(const Node& term) {
  if (term.is_number()) return constant(term.value);
  if (term.is_name()) {
    const std::size_t at = variables_.index(term.head);
    const Polynomial variable = Polynomial::variable(at, variables_);
    return {boxes_.at(0).at(at).is_squared ? variable * variable : variable, {variables_, Number(1)}};
  }
  if (term.head == "min" || term.head == "max") return extreme(term);
  const Fraction a = read(*term.parts[0]);
  if (term.parts.size() == 1) {
    Fraction opposite{Polynomial(variables_) - a.numerator, a.denominator};
    if (term.head == "-") return opposite;
    if (term.head == "sqrt") return root(a);
    if (term.head == "abs") return sign(a) < 0 ? opposite : a;
    throw Rejected("no polynomial has the operator " + term.head);
  }
  const Fraction b = read(*term.parts[1]);
  if (term.head == "+")
    return reduced(a.numerator * b.denominator + b.numerator * a.denominator, a.denominator * b.denominator);
  if (term.head == "-")
    return reduced(a.numerator * b.denominator - b.numerator * a.denominator, a.denominator * b.denominator);
  if (term.head == "*") return reduced(a.numerator * b.numerator, a.denominator * b.denominator);
  if (term.head == "/") return quotient(a, b);
  const auto numerator = b.numerator.constant();
  const auto denominator = b.denominator.constant();
  if (term.head != "^" || !numerator || !denominator) throw Rejected("no polynomial has the operator " + term.head);
  return power(a, *numerator / *denominator);
}

}  // namespace delcert::replay
