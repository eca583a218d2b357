#include "proofs/formula/evaluation.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace delcert {

namespace {

template <class S>
void prepare(RungCache<S>& cache) {
  if constexpr (std::same_as<S, BigInterval>) {
    const unsigned precision = BigInterval::working_precision().value;
    if (cache.precision != precision) cache.clear();
    cache.precision = precision;
  }
}

template <class S>
S power(const S& base, unsigned long exponent) {
  if (exponent == 0) return S(1);
  if (exponent == 1) return base;
  const S half = power(base, exponent / 2);
  return exponent % 2 == 0 ? S(square(half)) : S(square(half) * base);
}

/// Absent where the argument is negative, or may be.
template <class S>
Partial<S> root(const S& x) {
  const Verdict negative = less(x, S(0));
  return is_refuted(negative) ? Partial<S>(square_root(x)) : Partial<S>::absent(negation(negative));
}

template <class S>
Partial<S> quotient(const S& a, const S& b) {
  if (is_proved(is_zero(b))) return Partial<S>::absent(Verdict::refuted);
  return S(a / b);
}

template <class S>
Partial<S> power(const S& base, const Rational& exponent) {
  const Integer denominator = exponent.denominator();
  if (denominator != 1 && denominator != 2) return Partial<S>::absent(Verdict::refuted);
  constexpr long greatest = 1000000;
  if (absolute(exponent) > Rational(greatest)) return Partial<S>::absent(Verdict::undecided);
  Partial<S> radical = denominator == 2 ? root(base) : Partial<S>(base);
  if (!radical) return radical;
  const auto size = static_cast<unsigned long>(absolute(exponent).numerator());
  S result = power(*radical, size);
  return exponent < Rational(0) ? quotient(S(1), result) : Partial<S>(std::move(result));
}

}  // namespace

template <class S>
Evaluation<S>::Evaluation(Scene& scene) : scene_(scene) {
  prepare(scene.cache<S>());
}

template <class S>
const Argument<S>* Evaluation<S>::local(const std::string& name) const {
  for (std::size_t at = locals_.size(); at > visible_from_; --at) {
    if (locals_[at - 1].name == name) return &locals_[at - 1].value;
  }
  return nullptr;
}

template <class S>
Verdict Evaluation<S>::truth(const Expression& statement) {
  const auto part = [&](std::size_t at) { return truth(*statement.children[at]); };
  switch (statement.operation) {
    case Operation::negation:
      return delcert::negation(part(0));
    case Operation::conjunction: {
      const Verdict first = part(0);
      return is_refuted(first) ? first : delcert::conjunction(first, part(1));
    }
    case Operation::disjunction: {
      const Verdict first = part(0);
      return is_proved(first) ? first : delcert::disjunction(first, part(1));
    }
    case Operation::implication: {
      const Verdict first = part(0);
      return is_refuted(first) ? Verdict::proved : delcert::disjunction(delcert::negation(first), part(1));
    }
    case Operation::for_all:
    case Operation::exists:
      return quantified(statement);
    case Operation::call: {
      Verdict absence = Verdict::proved;
      std::vector<Argument<S>> arguments;
      for (const auto& child : statement.children) {
        auto value = argument(*child, absence);
        if (!value) return Verdict::undecided;
        arguments.push_back(std::move(*value));
      }
      return std::get<TruthFunction>(statement.function->value).template on<S>()(*this, arguments);
    }
    default:
      return comparison(statement);
  }
}

template <class S>
Verdict Evaluation<S>::comparison(const Expression& statement) {
  const Partial<S> left = number(*statement.children.at(0));
  const Partial<S> right = number(*statement.children.at(1));
  if (!left || !right) return Verdict::undecided;
  switch (statement.operation) {
    case Operation::less:
      return less(*left, *right);
    case Operation::less_equal:
      return less_equal(*left, *right);
    case Operation::greater:
      return less(*right, *left);
    case Operation::greater_equal:
      return less_equal(*right, *left);
    case Operation::equal:
      return is_zero(S(*left - *right));
    default:
      throw std::logic_error("a term where a statement was expected");
  }
}

template <class S>
Verdict Evaluation<S>::quantified(const Expression& statement) {
  const bool universal = statement.operation == Operation::for_all;
  Verdict result = verdict_of(universal);
  for (const Item& item : items_of(*statement.children[0])) {
    locals_.push_back({statement.text, item});
    const Verdict here = truth(*statement.children[1]);
    locals_.pop_back();
    result = universal ? delcert::conjunction(result, here) : delcert::disjunction(result, here);
    if (universal ? is_refuted(result) : is_proved(result)) break;
  }
  return result;
}

template <class S>
Partial<S> Evaluation<S>::number(const Expression& term) {
  switch (term.operation) {
    case Operation::literal:
      return scalar_from<S>(term.value);
    case Operation::name: {
      const auto of_item = [](const Item& value) { return scalar_from<S>(Rational(std::get<long>(value))); };
      if (const Argument<S>* value = local(term.text)) {
        if (const S* number = std::get_if<S>(value)) return *number;
        return of_item(std::get<Item>(*value));
      }
      const Binding* binding = sees_bindings_ ? scene_.find(term.text) : nullptr;
      if (binding == nullptr) throw std::logic_error("the instance has no " + term.text);
      if (const Rational* value = std::get_if<Rational>(binding)) return scalar_from<S>(*value);
      return scalar_from<S>(Rational(std::get<long>(*binding)));
    }
    case Operation::call:
      if (term.definition != nullptr) return call_definition(term);
      if (std::holds_alternative<ItemFunction>(term.function->value)) {
        return scalar_from<S>(Rational(std::get<long>(item(term))));
      }
      return call(term);
    default:
      return arithmetic(term);
  }
}

template <class S>
Partial<S> Evaluation<S>::arithmetic(const Expression& term) {
  const Partial<S> first = number(*term.children.at(0));
  if (!first) return first;
  if (term.operation == Operation::negate) return S(S(0) - *first);
  if (term.operation == Operation::power) return power(*first, exact(*term.children[1]));
  const Partial<S> second = number(*term.children.at(1));
  if (!second) return second;
  switch (term.operation) {
    case Operation::add:
      return S(*first + *second);
    case Operation::subtract:
      return S(*first - *second);
    case Operation::multiply:
      return S(*first * *second);
    case Operation::divide:
      return quotient(*first, *second);
    default:
      throw std::logic_error("a statement where a number was expected");
  }
}

template <class S>
std::optional<Argument<S>> Evaluation<S>::argument(const Expression& term, Verdict& absence) {
  if (term.type != types::number) return Argument<S>(item(term));
  Partial<S> value = number(term);
  if (value) return Argument<S>(std::move(*value));
  absence = value.exists();
  return std::nullopt;
}

template <class S>
Partial<S> Evaluation<S>::call(const Expression& term) {
  std::vector<Argument<S>> arguments;
  std::vector<Item> items;
  const auto& parameters = term.function->parameters;
  for (std::size_t at = 0; at < term.children.size(); ++at) {
    const auto& child = term.children[at];
    // An integer where a number is wanted.
    if (parameters[term.function->is_variadic ? 0 : at] == types::number) {
      Partial<S> value = number(*child);
      if (!value) return value;
      arguments.emplace_back(std::move(*value));
    } else {
      items.push_back(item(*child));
      arguments.emplace_back(items.back());
    }
  }
  const auto& function = std::get<NumberFunction>(term.function->value).template on<S>();
  if (items.size() != arguments.size()) return function(*this, arguments);
  auto& numbers = scene_.cache<S>().numbers;
  for (const auto& known : numbers) {
    if (known.function == term.function && known.arguments == items) return known.value;
  }
  Partial<S> value = function(*this, arguments);
  numbers.push_back({term.function, std::move(items), value});
  return value;
}

template <class S>
Partial<S> Evaluation<S>::call_definition(const Expression& term) {
  std::vector<Local> parameters;
  for (std::size_t at = 0; at < term.children.size(); ++at) {
    const Expression& child = *term.children[at];
    Verdict absence = Verdict::proved;
    auto value = child.type == types::integer ? Argument<S>(Item(static_cast<long>(exact(child).numerator())))
                                              : argument(child, absence);
    if (!value) return Partial<S>::absent(absence);
    parameters.push_back({term.definition->parameters[at], std::move(*value)});
  }
  const std::size_t outer = visible_from_;
  const bool outer_sees = sees_bindings_;
  visible_from_ = locals_.size();
  sees_bindings_ = false;
  for (Local& parameter : parameters) locals_.push_back(std::move(parameter));
  Partial<S> result = number(*term.definition->body);
  locals_.erase(locals_.begin() + static_cast<std::ptrdiff_t>(visible_from_), locals_.end());
  visible_from_ = outer;
  sees_bindings_ = outer_sees;
  return result;
}

template <class S>
Item Evaluation<S>::item(const Expression& term) {
  if (term.operation == Operation::name) {
    if (const Argument<S>* value = local(term.text)) return std::get<Item>(*value);
    const Binding* binding = scene_.find(term.text);
    if (binding == nullptr) throw std::logic_error("the instance has no " + term.text);
    if (const long* value = std::get_if<long>(binding)) return *value;
    return std::get<ObjectPointer>(*binding);
  }
  if (term.operation == Operation::call) {
    std::vector<Item> arguments;
    for (const auto& child : term.children) arguments.push_back(item(*child));
    return scene_.item(*term.function, arguments);
  }
  return static_cast<long>(exact(term).numerator());
}

template <class S>
std::vector<Item> Evaluation<S>::items_of(const Expression& set) {
  std::vector<Item> arguments;
  for (const auto& child : set.children) arguments.push_back(item(*child));
  return scene_.set(*set.function, arguments);
}

template <class S>
Rational Evaluation<S>::exact(const Expression& term) {
  const auto part = [&](std::size_t at) { return exact(*term.children.at(at)); };
  switch (term.operation) {
    case Operation::literal:
      return term.value;
    case Operation::negate:
      return -part(0);
    case Operation::add:
      return part(0) + part(1);
    case Operation::subtract:
      return part(0) - part(1);
    case Operation::multiply:
      return part(0) * part(1);
    case Operation::divide:
      return part(0) / part(1);
    case Operation::power:
      return delcert::power(part(0), static_cast<long>(part(1).numerator()));
    default:
      return Rational(std::get<long>(item(term)));
  }
}

template <class S>
std::optional<S> Evaluation<S>::ratio(const Expression& statement) {
  const auto best = [](const std::optional<S>& a, const std::optional<S>& b, bool greatest) {
    if (!a) return b;
    if (!b) return a;
    return std::optional<S>(greatest ? maximum(*a, *b) : minimum(*a, *b));
  };
  switch (statement.operation) {
    case Operation::conjunction:
    case Operation::disjunction:
      return best(ratio(*statement.children[0]), ratio(*statement.children[1]),
                  statement.operation == Operation::conjunction);
    case Operation::implication:
      return is_proved(truth(*statement.children[0])) ? ratio(*statement.children[1]) : std::nullopt;
    case Operation::for_all:
    case Operation::exists: {
      std::optional<S> result;
      for (const Item& item : items_of(*statement.children[0])) {
        locals_.push_back({statement.text, item});
        result = best(result, ratio(*statement.children[1]), statement.operation == Operation::for_all);
        locals_.pop_back();
      }
      return result;
    }
    default:
      return is_comparison(statement.operation) ? ratio_of_comparison(statement) : std::nullopt;
  }
}

template <class S>
std::optional<S> Evaluation<S>::ratio_of_comparison(const Expression& statement) {
  Partial<S> smaller = number(*statement.children[0]);
  Partial<S> larger = number(*statement.children[1]);
  if (statement.operation == Operation::greater || statement.operation == Operation::greater_equal) {
    std::swap(smaller, larger);
  }
  if (!smaller || !larger || !is_proved(less(S(0), *larger))) return std::nullopt;
  return S(*smaller / *larger);
}

template class Evaluation<Interval>;
template class Evaluation<BigInterval>;
template class Evaluation<Algebraic>;

Verdict decide_statement(const Expression& statement, Scene& scene) {
  return decide_algebraic([&]<class S>() { return Evaluation<S>(scene).truth(statement); });
}

std::optional<DoubleBounds> ratio_bounds(const Expression& statement, Scene& scene, bool sharp) {
  if (!sharp) {
    const RoundingGuard guard;
    const auto ratio = Evaluation<Interval>(scene).ratio(statement);
    if (!ratio) return std::nullopt;
    return DoubleBounds{ratio->lower(), ratio->upper()};
  }
  const BigInterval::Precision precision(PrecisionBits{256});
  const auto ratio = Evaluation<BigInterval>(scene).ratio(statement);
  if (!ratio) return std::nullopt;
  return DoubleBounds{mpfr_get_d(&ratio->mpfi()->left, MPFR_RNDD), mpfr_get_d(&ratio->mpfi()->right, MPFR_RNDU)};
}

std::optional<Rational> exact_value(const Expression& term, Scene& scene) {
  try {
    const Partial<Algebraic> value = Evaluation<Algebraic>(scene).number(term);
    if (!value || value->degree() != 1) return std::nullopt;
    return value->rational();
  } catch (const Undecided&) {
    return std::nullopt;
  }
}

std::optional<Rational> lower_bound(const Expression& term, Scene& scene, unsigned bits) {
  const Rational relative = Rational::power_of_two(-static_cast<long>(bits));
  for (unsigned precision_bits = 128; precision_bits <= 4096; precision_bits *= 2) {
    const BigInterval::Precision precision(PrecisionBits{precision_bits});
    const Partial<BigInterval> value = Evaluation<BigInterval>(scene).number(term);
    if (!value) {
      if (is_refuted(value.exists())) return std::nullopt;
      continue;
    }
    if (!value->is_bounded()) continue;
    const Rational lower = value->lower();
    const Rational upper = value->upper();
    if (upper - lower <= relative * maximum(absolute(lower), absolute(upper))) return lower;
  }
  return std::nullopt;
}

}  // namespace delcert
