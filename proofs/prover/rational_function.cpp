#include "proofs/prover/rational_function.hpp"

#include <algorithm>
#include <stdexcept>

namespace delcert {

namespace {

constexpr long greatest_exponent = 100000;

std::optional<Rational> constant_of(const RationalFunction& a) {
  const auto numerator = a.numerator.constant();
  const auto denominator = a.denominator.constant();
  if (!numerator || !denominator) return std::nullopt;
  return *numerator / *denominator;
}

bool is_square(const Rational& x) {
  return x >= Rational(0) && mpz_perfect_square_p(mpq_numref(x.gmp())) != 0 &&
         mpz_perfect_square_p(mpq_denref(x.gmp())) != 0;
}

/// The number of the variable if the polynomial is one.
std::optional<std::size_t> as_variable(const Polynomial& p) {
  for (std::size_t i = 0; i < p.ring()->variable_count(); ++i) {
    if (p == Polynomial::variable(p.ring(), i)) return i;
  }
  return std::nullopt;
}

}  // namespace

RationalFunctionReader::RationalFunctionReader(RingPointer ring, std::vector<bool> squared, SignOf sign_of)
    : ring_(std::move(ring)), squared_(std::move(squared)), sign_of_(std::move(sign_of)) {
  for (std::size_t i = 0; i < ring_->variable_count(); ++i) index_[ring_->names()[i]] = i;
}

RationalFunction RationalFunctionReader::constant(const Rational& value) const {
  return {Polynomial(ring_, value), Polynomial(ring_, Rational(1))};
}

std::optional<RationalFunction> RationalFunctionReader::read(const Expression& term) {
  const auto known = known_.find(&term);
  if (known != known_.end()) return known->second;
  Result result;
  try {
    result = compute(term);
  } catch (const std::length_error&) {
    // A power too large to be written out.
  }
  if (result && !is_moderate(*result)) result.reset();
  known_.emplace(&term, result);
  return result;
}

std::optional<RationalFunction> RationalFunctionReader::compute(const Expression& term) {
  switch (term.operation) {
    case Operation::literal:
      return constant(term.value);
    case Operation::name: {
      const std::size_t at = index_.at(term.text);
      const Polynomial variable = Polynomial::variable(ring_, at);
      return RationalFunction{squared_[at] ? variable * variable : variable, Polynomial(ring_, Rational(1))};
    }
    case Operation::call:
      return call(term);
    case Operation::power:
      return power(term);
    default:
      break;
  }
  const Result first = read(*term.children.at(0));
  if (!first) return std::nullopt;
  if (term.operation == Operation::negate) return RationalFunction{-first->numerator, first->denominator};
  const Result second = read(*term.children.at(1));
  if (!second) return std::nullopt;
  switch (term.operation) {
    case Operation::add:
    case Operation::subtract:
      return term.operation == Operation::add ? *first + *second : *first - *second;
    case Operation::multiply:
      return *first * *second;
    case Operation::divide:
      return quotient(*first, *second);
    default:
      return std::nullopt;
  }
}

std::optional<RationalFunction> RationalFunctionReader::quotient(const RationalFunction& a, const RationalFunction& b) {
  if (b.numerator.is_zero()) return std::nullopt;
  if (!b.numerator.constant()) divisors_.push_back(b.numerator);
  return reduced(a.numerator * b.denominator, a.denominator * b.numerator);
}

std::optional<RationalFunction> RationalFunctionReader::power(const Expression& term) {
  const Result base = read(*term.children[0]);
  const Result exponent_term = read(*term.children[1]);
  if (!base || !exponent_term) return std::nullopt;
  const auto exponent = constant_of(*exponent_term);
  if (!exponent || absolute(*exponent) > Rational(greatest_exponent)) return std::nullopt;
  if (exponent->denominator() == 1) return integer_power(*base, static_cast<long>(exponent->numerator()));
  if (exponent->denominator() != 2) return std::nullopt;
  const Result radical = root(*base);
  return radical ? integer_power(*radical, static_cast<long>(exponent->numerator())) : std::nullopt;
}

std::optional<RationalFunction> RationalFunctionReader::integer_power(const RationalFunction& base, long exponent) {
  const auto size = static_cast<unsigned long>(exponent < 0 ? -exponent : exponent);
  if (!has_moderate_power(base.numerator, size) || !has_moderate_power(base.denominator, size)) return std::nullopt;
  RationalFunction result{base.numerator.power(size), base.denominator.power(size)};
  if (exponent >= 0) return result;
  if (base.numerator.is_zero()) return std::nullopt;
  if (!base.numerator.constant()) divisors_.push_back(base.numerator);
  std::swap(result.numerator, result.denominator);
  return result;
}

/// |p|, if it is known which of p and −p that is.
std::optional<Polynomial> RationalFunctionReader::size(const Polynomial& p) const {
  switch (sign_of_(p)) {
    case Sign::positive:
    case Sign::nonnegative:
    case Sign::zero:
      return p;
    case Sign::negative:
    case Sign::nonpositive:
      return -p;
    default:
      return std::nullopt;
  }
}

std::optional<RationalFunction> RationalFunctionReader::root(const RationalFunction& a) {
  if (a.numerator.is_zero()) return a;
  const bool both_negative =
      a.numerator.terms().front().coefficient < Rational(0) && a.denominator.terms().front().coefficient < Rational(0);
  // √(N/D) = √(ND)/|D|
  const Polynomial product = a.numerator * a.denominator;
  if (const auto radical = product.square_root()) {
    const auto numerator = size(*radical);
    const auto denominator = size(both_negative ? -a.denominator : a.denominator);
    if (!numerator || !denominator) return std::nullopt;
    return reduced(*numerator, *denominator);
  }
  const auto factors = product.factors();
  if (!is_square(factors.constant)) return std::nullopt;
  std::set<std::size_t> wanted;
  for (const auto& factor : factors.powers) {
    if (factor.exponent % 2 == 0) continue;
    const auto variable = as_variable(factor.base);
    if (!variable || squared_[*variable]) return std::nullopt;
    const Sign sign = sign_of_(factor.base);
    if (sign != Sign::positive && sign != Sign::nonnegative) return std::nullopt;
    wanted.insert(*variable);
  }
  wanted_squares_.insert(wanted.begin(), wanted.end());
  return std::nullopt;
}

Sign RationalFunctionReader::sign(const RationalFunction& a) const {
  if (a.numerator.is_zero()) return Sign::zero;
  return product(sign_of_(a.numerator), sign_of_(a.denominator));
}

std::optional<RationalFunction> RationalFunctionReader::extreme(const Expression& term, bool greatest) {
  Result best = read(*term.children[0]);
  for (std::size_t at = 1; at < term.children.size() && best; ++at) {
    const Result next = read(*term.children[at]);
    if (!next) return std::nullopt;
    Sign difference = sign(*next - *best);
    if (difference == Sign::unknown) return std::nullopt;
    if (!greatest) difference = opposite(difference);
    if (difference == Sign::positive || difference == Sign::nonnegative) best = next;
  }
  return best;
}

std::optional<RationalFunction> RationalFunctionReader::call(const Expression& term) {
  if (term.text == "min" || term.text == "max") return extreme(term, term.text == "max");
  Result argument = read(*term.children.at(0));
  if (!argument) return std::nullopt;
  if (term.text == "sqrt") return root(*argument);
  if (term.text == "abs") {
    const Sign known = sign(*argument);
    if (known == Sign::unknown) return std::nullopt;
    if (known == Sign::negative || known == Sign::nonpositive) {
      return RationalFunction{-argument->numerator, argument->denominator};
    }
    return argument;
  }
  return std::nullopt;
}

}  // namespace delcert
