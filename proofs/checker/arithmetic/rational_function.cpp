#include "proofs/checker/arithmetic/rational_function.hpp"

#include <algorithm>
#include <stdexcept>

namespace delcert::checker {
namespace {

constexpr std::size_t most_terms = 3000, most_terms_of_divisors = 500, most_bits = 3000;
constexpr slong greatest_degree = 999;

const fmpq_mpoly_ctx_struct* context(std::size_t m) {
  struct Contexts {
    Contexts() {
      for (std::size_t k = 0; k < 4; ++k) fmpq_mpoly_ctx_init(of[k], static_cast<slong>(k), ORD_LEX);
    }
    fmpq_mpoly_ctx_t of[4];
  };
  static const Contexts contexts;
  return contexts.of[m];
}

[[noreturn]] void fail_as_too_large() { throw Undecided("a rational function is too large for this reader"); }

}  // namespace

Polynomial::Polynomial(std::size_t m, const Rational& constant) : m_(m) {
  fmpq_mpoly_init(value_, context(m_));
  fmpq_mpoly_set_fmpq(value_, constant.raw(), context(m_));
}
Polynomial Polynomial::variable(std::size_t m, std::size_t k) {
  Polynomial result(m, Rational(0));
  fmpq_mpoly_gen(result.value_, static_cast<slong>(k), context(m));
  return result;
}
Polynomial::Polynomial(const Polynomial& other) : m_(other.m_) {
  fmpq_mpoly_init(value_, context(m_));
  fmpq_mpoly_set(value_, other.value_, context(m_));
}
Polynomial::Polynomial(Polynomial&& other) noexcept : m_(other.m_) {
  fmpq_mpoly_init(value_, context(m_));
  fmpq_mpoly_swap(value_, other.value_, context(m_));
}
Polynomial& Polynomial::operator=(Polynomial other) noexcept {
  std::swap(m_, other.m_);
  std::swap(*value_, *other.value_);
  return *this;
}
Polynomial::~Polynomial() { fmpq_mpoly_clear(value_, context(m_)); }

bool Polynomial::is_zero() const { return fmpq_mpoly_is_zero(value_, context(m_)) != 0; }
bool Polynomial::is_constant() const { return fmpq_mpoly_is_fmpq(value_, context(m_)) != 0; }

std::size_t Polynomial::size() const { return static_cast<std::size_t>(fmpq_mpoly_length(value_, context(m_))); }

Rational Polynomial::at(const Vector<Rational>& x) const {
  Budget::spend(100 * (1 + size()));
  std::array<fmpq*, 4> places{};
  Vector<Rational> copy = x;
  for (std::size_t k = 0; k < m_; ++k) places[k] = copy[k].raw();
  Rational result;
  in_balls(64, [&] {
    if (fmpq_mpoly_evaluate_all_fmpq(result.raw(), value_, places.data(), context(m_)) == 0) fail_as_too_large();
  });
  return result;
}

std::string Polynomial::text() const {
  std::array<const char*, 3> names = {"x0", "x1", "x2"};
  char* text = fmpq_mpoly_get_str_pretty(value_, names.data(), context(m_));
  std::string result;
  for (const char* c = text; *c != '\0'; ++c) {
    if (*c != ' ') result += *c;
  }
  flint_free(text);
  return result;
}

namespace {

/// f(result), at a cost that grows with the sizes; throws Undecided for what is too large.
template <class F>
Polynomial calculated(std::size_t m, std::size_t cost, const F& f) {
  Budget::spend(100 + cost);
  Polynomial result(m, Rational(0));
  in_balls(64, [&] { f(result); });
  return result;
}

}  // namespace

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  return calculated(a.m_, a.size() + b.size(),
                    [&](Polynomial& sum) { fmpq_mpoly_add(sum.value_, a.value_, b.value_, context(a.m_)); });
}
Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  return calculated(a.m_, a.size() + b.size(),
                    [&](Polynomial& rest) { fmpq_mpoly_sub(rest.value_, a.value_, b.value_, context(a.m_)); });
}
Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.size() > most_terms || b.size() > most_terms) fail_as_too_large();
  return calculated(a.m_, a.size() * b.size(), [&](Polynomial& product) {
    fmpq_mpoly_mul(product.value_, a.value_, b.value_, context(a.m_));
    std::array<slong, 3> degrees{};
    if (fmpq_mpoly_degrees_fit_si(product.value_, context(a.m_)) == 0) fail_as_too_large();
    fmpq_mpoly_degrees_si(degrees.data(), product.value_, context(a.m_));
    for (std::size_t k = 0; k < a.m_; ++k) {
      if (degrees[k] > greatest_degree) fail_as_too_large();
    }
    const fmpq* content = product.value_->content;
    const slong bits = fmpz_mpoly_max_bits(product.value_->zpoly);
    if (fmpz_bits(fmpq_numref(content)) + fmpz_bits(fmpq_denref(content)) +
            static_cast<std::size_t>(bits < 0 ? -bits : bits) >
        most_bits)
      fail_as_too_large();
  });
}
bool operator==(const Polynomial& a, const Polynomial& b) {
  return fmpq_mpoly_equal(a.value_, b.value_, context(a.m_)) != 0;
}
Polynomial common_divisor(const Polynomial& a, const Polynomial& b) {
  if (a.size() > most_terms_of_divisors || b.size() > most_terms_of_divisors) fail_as_too_large();
  return calculated(a.m_, 2 * (a.size() + b.size()) * (a.size() + b.size()), [&](Polynomial& divisor) {
    if (fmpq_mpoly_gcd(divisor.value_, a.value_, b.value_, context(a.m_)) == 0) fail_as_too_large();
  });
}
Polynomial quotient(const Polynomial& a, const Polynomial& b) {
  return calculated(a.m_, a.size() * b.size(), [&](Polynomial& result) {
    if (fmpq_mpoly_divides(result.value_, a.value_, b.value_, context(a.m_)) == 0)
      throw std::logic_error("a common divisor does not divide");
  });
}

RationalFunction::RationalFunction(const Polynomial& above, const Polynomial& below)
    : numerator(above), denominator(below) {
  const Polynomial common = common_divisor(above, below);
  if (!common.is_constant()) {
    numerator = quotient(above, common);
    denominator = quotient(below, common);
  }
  if (!denominator.is_constant()) return;
  numerator = quotient(numerator, denominator);
  denominator = Polynomial(above.variable_count(), Rational(1));
}

RationalMap identity_map(std::size_t m) {
  RationalMap result;
  for (std::size_t k = 0; k < m; ++k) result.emplace_back(Polynomial::variable(m, k));
  return result;
}

namespace {

/// By squaring; of a quotient in lowest terms it is in lowest terms.
Polynomial raised(const Polynomial& base, std::size_t exponent) {
  if (exponent == 0) return Polynomial(base.variable_count(), Rational(1));
  const Polynomial half = raised(base, exponent / 2), whole = half * half;
  return exponent % 2 == 0 ? whole : whole * base;
}

}  // namespace

std::optional<RationalMap> composed(const FormulaMap& f, const RationalMap& x, const AbsoluteValue& absolute) {
  const std::size_t m = x.front().numerator.variable_count();
  RationalMap values;
  for (const auto& [operation, a, b] : f.steps()) {
    switch (operation) {
      case FormulaMap::Operation::constant:
        values.emplace_back(Polynomial(m, f.constant(a).exact));
        break;
      case FormulaMap::Operation::variable:
        values.push_back(x[a]);
        break;
      case FormulaMap::Operation::sum:
      case FormulaMap::Operation::difference: {
        const Polynomial left = values[a].numerator * values[b].denominator,
                         right = values[b].numerator * values[a].denominator;
        values.emplace_back(operation == FormulaMap::Operation::sum ? left + right : left - right,
                            values[a].denominator * values[b].denominator);
        break;
      }
      case FormulaMap::Operation::product:
        values.emplace_back(values[a].numerator * values[b].numerator, values[a].denominator * values[b].denominator);
        break;
      case FormulaMap::Operation::negative:
        values.emplace_back(Polynomial(m, Rational(0)) - values[a].numerator, values[a].denominator);
        break;
      case FormulaMap::Operation::reciprocal:
        if (values[a].numerator.is_zero()) return std::nullopt;
        values.emplace_back(values[a].denominator, values[a].numerator);
        break;
      case FormulaMap::Operation::power:
        values.emplace_back(raised(values[a].numerator, b), raised(values[a].denominator, b));
        break;
      case FormulaMap::Operation::absolute:
        if (absolute) {
          values.push_back(absolute(values.size(), values[a]));
          break;
        }
        [[fallthrough]];
      default:
        throw std::logic_error("no rational function");
    }
  }
  RationalMap result;
  for (std::size_t k = 0; k < f.function_count(); ++k) result.push_back(values[f.result(k)]);
  return result;
}

bool is_rational(const FormulaMap& f, bool folds) {
  return std::all_of(f.steps().begin(), f.steps().end(), [&](const FormulaMap::Step& step) {
    return step.operation < FormulaMap::Operation::root || (folds && step.operation == FormulaMap::Operation::absolute);
  });
}

namespace {

FormulaMap formulas_from(std::size_t m, const std::vector<std::string>& texts) {
  static const std::vector<std::string_view> names = {"x0", "x1", "x2"};
  try {
    return {{names.begin(), names.begin() + static_cast<std::ptrdiff_t>(m)}, {texts.begin(), texts.end()}};
  } catch (const Malformed&) {
    fail_as_too_large();
  }
}

}  // namespace

FormulaMap formulas_of(std::size_t m, const std::vector<Polynomial>& polynomials) {
  std::vector<std::string> texts;
  for (const Polynomial& p : polynomials) texts.push_back(p.text());
  return formulas_from(m, texts);
}

FormulaMap formulas_of(std::size_t m, const RationalMap& map) {
  std::vector<std::string> texts;
  for (const RationalFunction& f : map)
    texts.push_back(f.denominator.is_constant() ? f.numerator.text()
                                                : "(" + f.numerator.text() + ")/(" + f.denominator.text() + ")");
  return formulas_from(m, texts);
}

}  // namespace delcert::checker
