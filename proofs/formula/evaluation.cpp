#include "proofs/formula/evaluation.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "proofs/formula/partial_arithmetic.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

const Type& parameter_type(const Function& function, std::size_t at) {
  return function.parameters[function.is_variadic ? 0 : at];
}

template <class S>
void prepare(RungCache<S>& cache) {
  if constexpr (std::same_as<S, BigInterval>) {
    const unsigned precision = BigInterval::working_precision().value;
    if (cache.precision != precision) cache.clear();
    cache.precision = precision;
  }
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
    default:
      return leaf(statement);
  }
}

/// What the algebraic rung cannot tell, because a number is transcendental or of a large degree, may be clear from the
/// rung below: it must not keep the rest of the statement undecided, which only this rung may be able to decide.
template <class S>
Verdict Evaluation<S>::leaf(const Expression& statement) {
  if constexpr (!std::same_as<S, Algebraic>) {
    return leaf_on_this_rung(statement);
  } else {
    const std::size_t local_count = locals_.size();
    try {
      const Verdict verdict = leaf_on_this_rung(statement);
      if (!is_undecided(verdict)) return verdict;
    } catch (const Undecided&) {
      // It may have been thrown inside a definition, which no statement is.
      locals_.erase(locals_.begin() + static_cast<std::ptrdiff_t>(local_count), locals_.end());
      visible_from_ = 0;
      sees_bindings_ = true;
    }
    const BigInterval::Precision precision(PrecisionBits{greatest_precision});
    Evaluation<BigInterval> below(scene_);
    for (const Local& variable : locals_) below.locals_.push_back({variable.name, std::get<Item>(variable.value)});
    return below.leaf_on_this_rung(statement);
  }
}

template <class S>
Verdict Evaluation<S>::leaf_on_this_rung(const Expression& statement) {
  return statement.operation == Operation::call ? predicate(statement) : comparison(statement);
}

template <class S>
Verdict Evaluation<S>::predicate(const Expression& statement) {
  Verdict absence = Verdict::proved;
  std::vector<Argument<S>> arguments;
  for (std::size_t at = 0; at < statement.children.size(); ++at) {
    auto value = argument(*statement.children[at], parameter_type(*statement.function, at), absence);
    if (!value) return Verdict::undecided;
    arguments.push_back(std::move(*value));
  }
  return std::get<TruthFunction>(statement.function->value).template on<S>()(*this, arguments);
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
      return number_from<S>(term.value);
    case Operation::name: {
      const auto of_item = [](const Item& value) { return number_from<S>(std::get<long>(value)); };
      if (const Argument<S>* value = local(term.text)) {
        if (const S* number = std::get_if<S>(value)) return *number;
        return of_item(std::get<Item>(*value));
      }
      const Binding* binding = sees_bindings_ ? scene_.find(term.text) : nullptr;
      if (binding == nullptr) throw std::logic_error("the instance has no " + term.text);
      if (const Rational* value = std::get_if<Rational>(binding)) return number_from<S>(*value);
      return number_from<S>(std::get<long>(*binding));
    }
    case Operation::call:
      if (term.definition != nullptr) return call_definition(term);
      if (std::holds_alternative<ItemFunction>(term.function->value)) {
        return number_from<S>(std::get<long>(item(term)));
      }
      return call(term);
    case Operation::sum_over:
    case Operation::product_over:
    case Operation::least_over:
    case Operation::greatest_over:
      return over_set(term);
    default:
      return arithmetic(term);
  }
}

/// 0, 1 or nothing for an empty set, and then with each element in turn. A term that certainly has no value decides
/// that the whole has none.
template <class S>
Partial<S> Evaluation<S>::over_set(const Expression& term) {
  const bool is_sum = term.operation == Operation::sum_over;
  std::optional<S> result;
  if (is_sum || term.operation == Operation::product_over) result = S(is_sum ? 0 : 1);
  Verdict exists = Verdict::proved;
  for (const Item& item : items_of(*term.children[0])) {
    locals_.push_back({term.text, item});
    Partial<S> value = number(*term.children[1]);
    locals_.pop_back();
    if (!value) {
      exists = conjunction(exists, value.exists());
      if (is_refuted(exists)) break;
    } else if (!result) {
      result = std::move(*value);
    } else if (is_sum) {
      result = S(*result + *value);
    } else if (term.operation == Operation::product_over) {
      result = S(*result * *value);
    } else {
      result = term.operation == Operation::least_over ? minimum(*result, *value) : maximum(*result, *value);
    }
  }
  if (!is_proved(exists)) return Partial<S>::absent(exists);
  return result ? Partial<S>(std::move(*result)) : Partial<S>::absent(Verdict::refuted);
}

template <class S>
Partial<S> Evaluation<S>::arithmetic(const Expression& term) {
  Partial<S> first = number(*term.children.at(0));
  if (!first) return first;
  if (term.operation == Operation::negate) return S(S(0) - *first);
  if (term.operation == Operation::power) {
    const auto exponent = exact(*term.children[1]);
    return exponent ? partial_power(*first, *exponent) : Partial<S>::absent(Verdict::refuted);
  }
  Partial<S> second = number(*term.children.at(1));
  if (!second) return second;
  switch (term.operation) {
    case Operation::add:
      return S(*first + *second);
    case Operation::subtract:
      return S(*first - *second);
    case Operation::multiply:
      return S(*first * *second);
    case Operation::divide:
      return partial_quotient(*first, *second);
    default:
      throw std::logic_error("a statement where a number was expected");
  }
}

/// An integer serves as a number where a number is wanted.
template <class S>
std::optional<Argument<S>> Evaluation<S>::argument(const Expression& term, const Type& wanted, Verdict& absence) {
  if (wanted != types::number) return Argument<S>(item(term));
  Partial<S> value = number(term);
  if (value) return Argument<S>(std::move(*value));
  absence = value.exists();
  return std::nullopt;
}

template <class S>
Partial<S> Evaluation<S>::call(const Expression& term) {
  std::vector<Argument<S>> arguments;
  std::vector<Item> items;
  for (std::size_t at = 0; at < term.children.size(); ++at) {
    Verdict absence = Verdict::proved;
    auto value = argument(*term.children[at], parameter_type(*term.function, at), absence);
    if (!value) return Partial<S>::absent(absence);
    if (const Item* same_on_every_rung = std::get_if<Item>(&*value)) items.push_back(*same_on_every_rung);
    arguments.push_back(std::move(*value));
  }
  const auto& function = std::get<NumberFunction>(term.function->value).template on<S>();
  if (items.size() != arguments.size()) return function(*this, arguments);
  auto& numbers = scene_.cache<S>().numbers;
  if (const auto* known = numbers.find(*term.function, items)) return *known;
  return numbers.add(*term.function, items, function(*this, arguments));
}

template <class S>
Partial<S> Evaluation<S>::call_definition(const Expression& term) {
  std::vector<Local> parameters;
  for (std::size_t at = 0; at < term.children.size(); ++at) {
    const Expression& child = *term.children[at];
    Verdict absence = Verdict::proved;
    auto value = argument(child, child.type, absence);
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
  return integer(term);
}

template <class S>
std::vector<Item> Evaluation<S>::items_of(const Expression& set) {
  std::vector<Item> arguments;
  for (const auto& child : set.children) arguments.push_back(item(*child));
  return scene_.set(*set.function, arguments);
}

/// The value of a term of the type integer. Objects count in `long`, and differences of what it holds must fit, too.
template <class S>
long Evaluation<S>::integer(const Expression& term) {
  constexpr long greatest = 1000000000000000000;
  const auto value = exact(term);
  if (!value || absolute(*value) > Rational(greatest)) throw InputError("a formula has an integer beyond 10^18");
  return static_cast<long>(value->numerator());
}

/// The value of a term that is made of integers; nothing where it divides by 0.
template <class S>
std::optional<Rational> Evaluation<S>::exact(const Expression& term) {
  if (term.operation == Operation::literal) return term.value;
  if (term.operation == Operation::name || term.operation == Operation::call) {
    return Rational(std::get<long>(item(term)));
  }
  const auto first = exact(*term.children.at(0));
  if (!first) return std::nullopt;
  if (term.operation == Operation::negate) return -*first;
  const auto second = exact(*term.children.at(1));
  if (!second) return std::nullopt;
  switch (term.operation) {
    case Operation::add:
      return *first + *second;
    case Operation::subtract:
      return *first - *second;
    case Operation::multiply:
      return *first * *second;
    case Operation::divide:
      if (*second == Rational(0)) return std::nullopt;
      return *first / *second;
    case Operation::power: {
      constexpr long greatest_base = 1000000000000000000;
      if (absolute(*first) > Rational(greatest_base)) throw InputError("a formula has an integer beyond 10^18");
      return delcert::power(*first, static_cast<long>(second->numerator()));
    }
    default:
      throw std::logic_error("a statement where an integer was expected");
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
template class Evaluation<Surd>;
template class Evaluation<Algebraic>;

}  // namespace delcert
