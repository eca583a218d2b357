#include "kernel/formula/rational_function.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernel/formula/plain_formula.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_terms = 3000;
constexpr unsigned long greatest_degree = 2000;

[[noreturn]] void fail_as_too_large() { throw std::length_error("a rational function is too large to be written out"); }

Polynomial moderate_product(const Polynomial& a, const Polynomial& b) {
  if (a.term_count() > most_terms || b.term_count() > most_terms) fail_as_too_large();
  return a * b;
}

Polynomial moderate_power(const Polynomial& base, unsigned long exponent) {
  if (!has_moderate_power(base, exponent)) fail_as_too_large();
  return base.power(exponent);
}

/// All powers up to this one.
std::vector<Polynomial> powers_of(const Polynomial& base, unsigned long greatest) {
  if (!has_moderate_power(base, greatest)) fail_as_too_large();
  std::vector<Polynomial> result{Polynomial(base.ring(), Rational(1))};
  while (result.size() <= greatest) result.push_back(result.back() * base);
  return result;
}

RationalFunction sum(const RationalFunction& a, const RationalFunction& b, bool subtract) {
  const Polynomial common = Polynomial::common_divisor(a.denominator, b.denominator);
  const Polynomial for_a = Polynomial::exact_quotient(b.denominator, common);
  const Polynomial for_b = Polynomial::exact_quotient(a.denominator, common);
  const Polynomial left = moderate_product(a.numerator, for_a);
  const Polynomial right = moderate_product(b.numerator, for_b);
  return reduced(subtract ? left - right : left + right, moderate_product(a.denominator, for_a));
}

/// A quotient that need not be reduced.
struct Fraction {
  Polynomial numerator;
  Polynomial denominator;
};

Fraction unreduced(const Polynomial& p, const std::vector<RationalFunction>& f) {
  const RingPointer& ring = f.front().numerator.ring();
  const std::vector<unsigned long> degrees = p.degrees();
  std::vector<std::vector<Polynomial>> above;
  std::vector<std::vector<Polynomial>> below;
  Polynomial denominator(ring, Rational(1));
  for (std::size_t at = 0; at < f.size(); ++at) {
    above.push_back(powers_of(f[at].numerator, degrees[at]));
    below.push_back(powers_of(f[at].denominator, degrees[at]));
    denominator = moderate_product(denominator, below.back().back());
  }
  Polynomial numerator(ring);
  for (const Polynomial::Term& term : p.terms()) {
    Polynomial product(ring, term.coefficient);
    for (std::size_t at = 0; at < f.size(); ++at) {
      product = moderate_product(product, above[at][term.exponents[at]]);
      product = moderate_product(product, below[at][degrees[at] - term.exponents[at]]);
    }
    numerator = numerator + product;
  }
  return {std::move(numerator), std::move(denominator)};
}

RationalFunction read(const Expression& formula, const std::vector<std::string>& variables, const RingPointer& ring,
                      const AbsoluteValue& absolute_value) {
  const auto argument = [&](std::size_t at) { return read(*formula.children[at], variables, ring, absolute_value); };
  switch (formula.operation) {
    case Operation::literal:
      return {Polynomial(ring, formula.value), Polynomial(ring, Rational(1))};
    case Operation::name:
      return variable_function(
          ring,
          static_cast<std::size_t>(std::find(variables.begin(), variables.end(), formula.text) - variables.begin()));
    case Operation::negate: {
      const RationalFunction a = argument(0);
      return {-a.numerator, a.denominator};
    }
    case Operation::add:
      return argument(0) + argument(1);
    case Operation::subtract:
      return argument(0) - argument(1);
    case Operation::multiply:
      return argument(0) * argument(1);
    case Operation::divide: {
      const RationalFunction divisor = argument(1);
      if (divisor.numerator.is_zero()) throw std::domain_error("a division by 0");
      return argument(0) / divisor;
    }
    case Operation::power: {
      const RationalFunction base = argument(0);
      const auto exponent = formula.children[1]->value.numerator().convert_to<unsigned long>();
      return {moderate_power(base.numerator, exponent), moderate_power(base.denominator, exponent)};
    }
    case Operation::call:
      if (absolute_value && has_absolute_values(formula)) {
        if (auto value = absolute_value(argument(0))) return *std::move(value);
      }
      [[fallthrough]];
    default:
      throw std::domain_error("no rational function");
  }
}

}  // namespace

bool is_moderate(const RationalFunction& a) {
  return a.numerator.term_count() <= most_terms && a.denominator.term_count() <= most_terms;
}

bool has_moderate_power(const Polynomial& base, unsigned long exponent) {
  if (base.constant()) return true;
  for (const unsigned long degree : base.degrees()) {
    if (degree > 0 && exponent > greatest_degree / degree) return false;
  }
  // Of t terms to the power e there are at most C(e + t − 1, t − 1).
  double terms = 1;
  for (std::size_t i = 1; i < base.term_count(); ++i) {
    terms *= static_cast<double>(exponent + i) / static_cast<double>(i);
    if (terms > static_cast<double>(most_terms)) return false;
  }
  return true;
}

RationalFunction reduced(const Polynomial& numerator, const Polynomial& denominator) {
  const RingPointer& ring = numerator.ring();
  if (const auto value = denominator.constant()) {
    return {numerator * Polynomial(ring, Rational(1) / *value), Polynomial(ring, Rational(1))};
  }
  const Polynomial common = Polynomial::common_divisor(numerator, denominator);
  if (common.constant()) return {numerator, denominator};
  return reduced(Polynomial::exact_quotient(numerator, common), Polynomial::exact_quotient(denominator, common));
}

RationalFunction variable_function(const RingPointer& ring, std::size_t index) {
  return {Polynomial::variable(ring, index), Polynomial(ring, Rational(1))};
}

RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) { return sum(a, b, false); }
RationalFunction operator-(const RationalFunction& a, const RationalFunction& b) { return sum(a, b, true); }
RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
  return reduced(moderate_product(a.numerator, b.numerator), moderate_product(a.denominator, b.denominator));
}
RationalFunction operator/(const RationalFunction& a, const RationalFunction& b) {
  return reduced(moderate_product(a.numerator, b.denominator), moderate_product(a.denominator, b.numerator));
}
bool operator==(const RationalFunction& a, const RationalFunction& b) {
  return moderate_product(a.numerator, b.denominator) == moderate_product(b.numerator, a.denominator);
}

std::optional<RationalFunction> rational_function_of(const Expression& formula,
                                                     const std::vector<std::string>& variables, const RingPointer& ring,
                                                     const AbsoluteValue& absolute_value) {
  try {
    RationalFunction result = read(formula, variables, ring, absolute_value);
    if (is_moderate(result)) return result;
  } catch (const std::length_error&) {
  } catch (const std::domain_error&) {
  }
  return std::nullopt;
}

RationalFunction composed(const Polynomial& p, const std::vector<RationalFunction>& f) {
  const Fraction result = unreduced(p, f);
  return reduced(result.numerator, result.denominator);
}

std::optional<RationalFunction> composed(const RationalFunction& g, const std::vector<RationalFunction>& f) {
  const RationalFunction divisor = composed(g.denominator, f);
  if (divisor.numerator.is_zero()) return std::nullopt;
  return composed(g.numerator, f) / divisor;
}

std::optional<Rational> value_at(const RationalFunction& f, const std::vector<Rational>& x) {
  const Rational divisor = f.denominator.at(x);
  if (divisor == Rational(0)) return std::nullopt;
  return f.numerator.at(x) / divisor;
}

}  // namespace delcert
