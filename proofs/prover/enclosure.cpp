#include "proofs/prover/enclosure.hpp"

#include <algorithm>

namespace delcert {

namespace {

using Value = std::optional<ExtendedInterval>;

ExtendedInterval number(long value, PrecisionBits precision) { return {Rational(value), precision}; }

Value integer_power(const ExtendedInterval& base, long exponent) {
  const auto size = static_cast<unsigned long>(exponent < 0 ? -exponent : exponent);
  const ExtendedInterval result = power(base, size);
  return exponent < 0 ? quotient(number(1, base.precision()), result) : Value(result);
}

/// ln 2
ExtendedInterval natural_logarithm_of_two(PrecisionBits precision) {
  // 1/log2(e), from bounds of e by its series: Σ_{i <= n} 1/i! < e < the same + 2/(n + 1)!
  static const auto bounds = [] {
    Rational sum(1);
    Rational term(1);
    for (int i = 1; i <= 60; ++i) {
      term /= Rational(i);
      sum += term;
    }
    return std::pair(sum, sum + term);
  }();
  const auto logarithm = binary_logarithm(ExtendedInterval(bounds.first, true, bounds.second, true, precision));
  return *quotient(number(1, precision), *logarithm);
}

Sign sign_of(const ExtendedInterval& x) {
  if (x.is_zero()) return Sign::zero;
  if (x.is_positive()) return Sign::positive;
  if (x.is_negative()) return Sign::negative;
  if (x.is_nonnegative()) return Sign::nonnegative;
  return x.is_nonpositive() ? Sign::nonpositive : Sign::unknown;
}

}  // namespace

EnclosureTape::EnclosureTape(const std::vector<std::string>& parameters) {
  for (std::size_t i = 0; i < parameters.size(); ++i) index_[parameters[i]] = i;
}

std::size_t EnclosureTape::append(Node node) {
  nodes_.push_back(std::move(node));
  return nodes_.size() - 1;
}

std::size_t EnclosureTape::extreme(const Expression& term, Code code) {
  std::size_t result = add(term.children[0]);
  for (std::size_t at = 1; at < term.children.size(); ++at)
    result = append({code, result, add(term.children[at]), 0, {}});
  return result;
}

std::size_t EnclosureTape::power_node(const Expression& term) {
  constexpr long greatest = 1000000;
  const std::size_t base = add(term.children[0]);
  const std::size_t exponent = add(term.children[1]);
  evaluate(ParameterBox(index_.size(), ExtendedInterval(PrecisionBits{64})));
  const auto& value = values_[exponent];
  // A constant exponent is a small number of halves, so that its double is exact.
  if (value && value->approximate_width() == 0) {
    const double twice = 2 * mpfr_get_d(value->lower().raw(), MPFR_RNDN);
    const long halves = twice >= -greatest && twice <= greatest ? static_cast<long>(twice) : 0;
    if (static_cast<double>(halves) == twice && !value->lower().open) {
      if (halves % 2 == 0) return append({Code::integer_power, base, 0, halves / 2, {}});
      return append({Code::integer_power, append({Code::root, base, 0, 0, {}}), 0, halves, {}});
    }
  }
  return append({Code::power, base, exponent, 0, {}});
}

std::size_t EnclosureTape::add(const ExpressionPointer& term) {
  const auto known = known_.find(term.get());
  if (known != known_.end()) return known->second;
  const auto unary = [&](Code code) { return append({code, add(term->children[0]), 0, 0, {}}); };
  const auto binary = [&](Code code) {
    const std::size_t first = add(term->children[0]);
    return append({code, first, add(term->children[1]), 0, {}});
  };
  std::size_t result = 0;
  switch (term->operation) {
    case Operation::literal:
      result = append({Code::constant, 0, 0, 0, term->value});
      break;
    case Operation::name:
      result = append({Code::parameter, index_.at(term->text), 0, 0, {}});
      break;
    case Operation::negate:
      result = unary(Code::negate);
      break;
    case Operation::add:
      result = binary(Code::add);
      break;
    case Operation::subtract:
      result = binary(Code::subtract);
      break;
    case Operation::multiply:
      result = binary(Code::multiply);
      break;
    case Operation::divide:
      result = binary(Code::divide);
      break;
    case Operation::power:
      result = power_node(*term);
      break;
    default:
      if (term->text == "sqrt") result = unary(Code::root);
      if (term->text == "log2") result = unary(Code::logarithm);
      if (term->text == "abs") result = unary(Code::absolute);
      if (term->text == "min") result = extreme(*term, Code::minimum);
      if (term->text == "max") result = extreme(*term, Code::maximum);
  }
  known_[term.get()] = result;
  kept_.push_back(term);
  return result;
}

std::size_t EnclosureTape::add_difference(const ExpressionPointer& a, const ExpressionPointer& b) {
  const std::size_t first = add(a);
  return append({Code::subtract, first, add(b), 0, {}});
}

EnclosureTape::Value EnclosureTape::compute(const Node& node, const ParameterBox& box) const {
  if (node.code == Code::constant) {
    const auto precision = box.empty() ? PrecisionBits{64} : box[0].precision();
    return ExtendedInterval(node.value, precision);
  }
  if (node.code == Code::parameter) return box[node.first];
  const Value& a = values_[node.first];
  if (!a) return std::nullopt;
  switch (node.code) {
    case Code::negate:
      return -*a;
    case Code::integer_power:
      return integer_power(*a, node.exponent);
    case Code::root:
      return square_root(*a);
    case Code::logarithm:
      return binary_logarithm(*a);
    case Code::absolute:
      return absolute(*a);
    default:
      break;
  }
  const Value& b = values_[node.second];
  if (!b) return std::nullopt;
  switch (node.code) {
    case Code::add:
      return *a + *b;
    case Code::subtract:
      return *a - *b;
    case Code::multiply:
      return *a * *b;
    case Code::divide:
      return quotient(*a, *b);
    case Code::power:
      return power(*a, *b);
    case Code::minimum:
      return minimum(*a, *b);
    default:
      return maximum(*a, *b);
  }
}

void EnclosureTape::evaluate(const ParameterBox& box) {
  values_.assign(nodes_.size(), std::nullopt);
  for (std::size_t at = 0; at < nodes_.size(); ++at) values_[at] = compute(nodes_[at], box);
}

/// Forward differentiation; nothing where the derivative may not exist. Precondition: the node has a value.
EnclosureTape::Value EnclosureTape::derivative_of(const Node& node, std::size_t at, std::size_t parameter,
                                                  PrecisionBits precision) const {
  if (node.code == Code::constant) return number(0, precision);
  if (node.code == Code::parameter) return number(node.first == parameter ? 1 : 0, precision);
  const ExtendedInterval& a = *values_[node.first];
  const Value& da = derivatives_[node.first];
  if (!da) return std::nullopt;
  switch (node.code) {
    case Code::negate:
      return -*da;
    case Code::integer_power: {
      if (node.exponent == 0 || da->is_zero()) return number(0, precision);
      const Value inner = integer_power(a, node.exponent - 1);
      if (!inner) return std::nullopt;
      return number(node.exponent, precision) * *inner * *da;
    }
    case Code::root:
      if (da->is_zero()) return da;
      return quotient(*da, number(2, precision) * *values_[at]);
    case Code::logarithm:
      return quotient(*da, a * natural_logarithm_of_two(precision));
    case Code::absolute:
      if (a.is_nonnegative()) return da;
      return a.is_nonpositive() ? -*da : ExtendedInterval::hull(*da, -*da);
    default:
      break;
  }
  const ExtendedInterval& b = *values_[node.second];
  const Value& db = derivatives_[node.second];
  if (!db) return std::nullopt;
  switch (node.code) {
    case Code::add:
      return *da + *db;
    case Code::subtract:
      return *da - *db;
    case Code::multiply:
      return *da * b + a * *db;
    case Code::divide:
      return quotient(*da - *values_[at] * *db, b);
    case Code::power: {
      // a^b (b' ln a + b a'/a)
      const auto logarithm = binary_logarithm(a);
      if (!logarithm) return std::nullopt;
      const auto relative = quotient(*da, a);
      if (!relative) return std::nullopt;
      return *values_[at] * (*db * *logarithm * natural_logarithm_of_two(precision) + b * *relative);
    }
    default:
      return ExtendedInterval::hull(*da, *db);
  }
}

void EnclosureTape::differentiate(std::size_t last, const ParameterBox& box, std::size_t parameter) {
  derivatives_.assign(nodes_.size(), std::nullopt);
  for (std::size_t at = 0; at <= last; ++at) {
    if (values_[at]) derivatives_[at] = derivative_of(nodes_[at], at, parameter, box[parameter].precision());
  }
}

/// Where a term is monotone in some parameters, its bound on the face where it is least (greatest).
EnclosureTape::Value EnclosureTape::bound_on_face(std::size_t term, const ParameterBox& box,
                                                  const std::vector<Sign>& slopes, bool least) {
  ParameterBox face = box;
  bool strict = false;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const bool grows = slopes[i] == Sign::positive || slopes[i] == Sign::nonnegative || slopes[i] == Sign::zero;
    const bool falls = slopes[i] == Sign::negative || slopes[i] == Sign::nonpositive;
    if (!grows && !falls) continue;
    const bool at_lower = grows == least;
    const auto& end = at_lower ? box[i].lower() : box[i].upper();
    if (end.is_infinite()) continue;
    face[i] = ExtendedInterval::at(end);
    strict = strict || (end.open && is_strict(slopes[i]));
  }
  evaluate(face);
  Value result = values_[term];
  if (result && strict) result = least ? result->with_open_lower() : result->with_open_upper();
  return result;
}

Sign EnclosureTape::sign(std::size_t term, const ParameterBox& box) {
  evaluate(box);
  if (!values_[term]) return Sign::unknown;
  const ExtendedInterval direct = *values_[term];
  const Sign known = sign_of(direct);
  if (known != Sign::unknown) return known;
  std::vector<Sign> slopes(box.size(), Sign::unknown);
  bool is_monotone = false;
  for (std::size_t i = 0; i < box.size(); ++i) {
    const bool is_point = mpfr_equal_p(box[i].lower().raw(), box[i].upper().raw()) != 0;
    if (is_point) continue;
    differentiate(term, box, i);
    if (derivatives_[term]) slopes[i] = sign_of(*derivatives_[term]);
    is_monotone = is_monotone || slopes[i] != Sign::unknown;
  }
  if (!is_monotone) return Sign::unknown;
  const Value least = bound_on_face(term, box, slopes, true);
  const Value greatest = bound_on_face(term, box, slopes, false);
  const ExtendedInterval from_below = least ? ExtendedInterval::between(least->lower(), direct.upper()) : direct;
  return sign_of(greatest ? ExtendedInterval::between(from_below.lower(), greatest->upper()) : from_below);
}

}  // namespace delcert
