#include "proofs/formula/type_check.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/parser.hpp"

namespace delcert {

namespace {

constexpr long greatest_literal_exponent = 1000000;
/// A power of an integer is an integer up to this exponent.
constexpr long greatest_integer_exponent = 64;

/// "an integer", "a statement", "a set of simplex".
std::string described(const Type& type) {
  const std::string text = type == types::truth ? "statement" : type.text();
  const bool begins_with_vowel = std::string_view("aeiou").find(text[0]) != std::string_view::npos;
  return (begins_with_vowel ? "an " : "a ") + text;
}

/// The value of a term without names and functions; nothing for others, and for a division by 0 or huge powers.
std::optional<Rational> literal_value(const Expression& expression) {
  std::vector<Rational> parts;
  for (const auto& child : expression.children) {
    const auto part = literal_value(*child);
    if (!part) return std::nullopt;
    parts.push_back(*part);
  }
  switch (expression.operation) {
    case Operation::literal:
      return expression.value;
    case Operation::negate:
      return -parts[0];
    case Operation::add:
      return parts[0] + parts[1];
    case Operation::subtract:
      return parts[0] - parts[1];
    case Operation::multiply:
      return parts[0] * parts[1];
    case Operation::divide:
      if (parts[1] == Rational(0)) return std::nullopt;
      return parts[0] / parts[1];
    case Operation::power:
      if (parts[1].denominator() != 1 || parts[1] < Rational(0) || parts[1] > Rational(greatest_integer_exponent) ||
          absolute(parts[0]) > Rational(greatest_literal_exponent)) {
        return std::nullopt;
      }
      return power(parts[0], static_cast<long>(parts[1].numerator()));
    default:
      return std::nullopt;
  }
}

bool has_leaves_of_numbers_only(const Expression& expression) {
  if (expression.operation == Operation::name || expression.operation == Operation::call) return false;
  return std::all_of(expression.children.begin(), expression.children.end(),
                     [](const auto& child) { return has_leaves_of_numbers_only(*child); });
}

bool serves_as(const Type& type, const Type& wanted) {
  return type == wanted || (type == types::integer && wanted == types::number);
}

class Checker {
 public:
  Checker(const Vocabulary& vocabulary, Signature signature)
      : vocabulary_(vocabulary), signature_(std::move(signature)) {}

  ExpressionPointer checked(const ExpressionPointer& expression, const Type& wanted) {
    auto result = checked(expression);
    if (!serves_as(result->type, wanted)) {
      throw FormulaError(expression->offset, described(result->type) + " where " + described(wanted) + " was expected");
    }
    return result;
  }

  ExpressionPointer checked(const ExpressionPointer& expression) {
    auto result = std::make_shared<Expression>(*expression);
    switch (result->operation) {
      case Operation::literal:
        result->type = types::integer;
        break;
      case Operation::name:
        result->type = type_of_name(*result);
        break;
      case Operation::call:
        check_call(*result);
        break;
      case Operation::negate:
      case Operation::add:
      case Operation::subtract:
      case Operation::multiply:
        check_children(*result, types::number);
        result->type = all_integers(*result) ? types::integer : types::number;
        break;
      case Operation::divide:
        check_children(*result, types::number);
        result->type = types::number;
        break;
      case Operation::power:
        check_children(*result, types::number);
        check_exponent(*result->children[1]);
        result->type = is_power_of_integer(*result) ? types::integer : types::number;
        break;
      case Operation::less:
      case Operation::less_equal:
      case Operation::greater:
      case Operation::greater_equal:
      case Operation::equal:
        check_children(*result, types::number);
        result->type = types::truth;
        break;
      case Operation::negation:
      case Operation::conjunction:
      case Operation::disjunction:
      case Operation::implication:
        check_children(*result, types::truth);
        result->type = types::truth;
        break;
      case Operation::for_all:
      case Operation::exists:
        check_quantifier(*result);
        break;
      case Operation::sum_over:
      case Operation::product_over:
      case Operation::least_over:
      case Operation::greatest_over:
        check_over_set(*result, types::number);
        break;
    }
    return result;
  }

 private:
  void check_children(Expression& expression, const Type& wanted) {
    for (auto& child : expression.children) child = checked(child, wanted);
  }

  static bool all_integers(const Expression& expression) {
    return std::all_of(expression.children.begin(), expression.children.end(),
                       [](const auto& child) { return child->type == types::integer; });
  }

  static bool is_power_of_integer(const Expression& expression) {
    const Expression& exponent = *expression.children[1];
    return expression.children[0]->type == types::integer && exponent.operation == Operation::literal &&
           exponent.value <= Rational(greatest_integer_exponent);
  }

  static void check_exponent(const Expression& exponent) {
    if (!is_made_of_integers(exponent)) {
      throw FormulaError(exponent.offset, "an exponent must be made of integers and halves of them");
    }
    if (!has_leaves_of_numbers_only(exponent)) return;
    const auto value = literal_value(exponent);
    if (!value || (value->denominator() != 1 && value->denominator() != 2)) {
      throw FormulaError(exponent.offset, "an exponent that is neither an integer nor half of one");
    }
    if (absolute(*value) > Rational(greatest_literal_exponent)) {
      throw FormulaError(exponent.offset, "an exponent beyond 1000000");
    }
  }

  static bool is_made_of_integers(const Expression& expression) {
    if (expression.operation == Operation::divide) {
      return is_made_of_integers(*expression.children[0]) && expression.children[1]->type == types::integer;
    }
    if (expression.type == types::integer) return true;
    return (expression.operation == Operation::add || expression.operation == Operation::subtract ||
            expression.operation == Operation::multiply || expression.operation == Operation::negate) &&
           std::all_of(expression.children.begin(), expression.children.end(),
                       [](const auto& child) { return is_made_of_integers(*child); });
  }

  Type type_of_name(const Expression& expression) const {
    const auto found = signature_.find(expression.text);
    if (found != signature_.end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [name, type] : signature_) known.push_back(name);
    if (vocabulary_.function(expression.text) != nullptr || vocabulary_.definition(expression.text) != nullptr) {
      throw FormulaError(expression.offset, expression.text + " is a function: its arguments are missing");
    }
    std::string all;
    for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
    throw FormulaError(expression.offset, "nothing here is called " + expression.text +
                                              suggestion(expression.text, known) +
                                              (all.empty() ? "" : " (there are " + all + ")"));
  }

  void check_call(Expression& expression) {
    expression.function = vocabulary_.function(expression.text);
    expression.definition = vocabulary_.definition(expression.text);
    if (expression.definition != nullptr) {
      const auto& parameters = expression.definition->parameters;
      require_count(expression, parameters.size(), false);
      check_children(expression, types::number);
      for (std::size_t at = 0; at < parameters.size(); ++at) {
        const bool wants_integer = parameters[at] == "k" || parameters[at] == "m";
        if (wants_integer && expression.children[at]->type != types::integer) {
          throw FormulaError(expression.children[at]->offset,
                             expression.text + " expects an integer as argument " + std::to_string(at + 1));
        }
      }
      expression.type = types::number;
      return;
    }
    if (expression.function == nullptr && signature_.contains(expression.text)) {
      throw FormulaError(expression.offset,
                         expression.text + " is a name, not a function: products are written with *");
    }
    if (expression.function == nullptr && operation_over_set(expression.text)) {
      throw FormulaError(expression.offset, expression.text + " runs through a set: " + expression.text +
                                                "(p in vertices(s): altitude(s, p))");
    }
    if (expression.function == nullptr) {
      throw FormulaError(expression.offset,
                         "no function is called " + expression.text + suggestion(expression.text, vocabulary_.names()));
    }
    const auto& parameters = expression.function->parameters;
    require_count(expression, parameters.size(), expression.function->is_variadic);
    for (std::size_t at = 0; at < expression.children.size(); ++at) {
      auto& child = expression.children[at];
      const Type& wanted = parameters[expression.function->is_variadic ? 0 : at];
      child = checked(child);
      if (!serves_as(child->type, wanted)) {
        throw FormulaError(child->offset, expression.text + " expects " + described(wanted) + " as argument " +
                                              std::to_string(at + 1) + ", not " + described(child->type));
      }
    }
    expression.type = expression.function->result;
  }

  static void require_count(const Expression& expression, std::size_t wanted, bool is_variadic) {
    const std::size_t given = expression.children.size();
    if (is_variadic ? given >= 2 : given == wanted) return;
    throw FormulaError(expression.offset, expression.text + " expects " +
                                              (is_variadic ? "two or more" : std::to_string(wanted)) +
                                              (!is_variadic && wanted == 1 ? " argument" : " arguments") + ", not " +
                                              std::to_string(given));
  }

  void check_quantifier(Expression& expression) { check_over_set(expression, types::truth); }

  /// What is said of each element of a set is of the type `wanted`, and so is the whole.
  void check_over_set(Expression& expression, const Type& wanted) {
    if (signature_.contains(expression.text)) {
      throw FormulaError(expression.offset, "the variable " + expression.text + " is already something else");
    }
    if (vocabulary_.function(expression.text) != nullptr || vocabulary_.definition(expression.text) != nullptr) {
      throw FormulaError(expression.offset, "the variable " + expression.text + " is called like a function");
    }
    auto& set = expression.children[0];
    set = checked(set);
    if (!set->type.is_set) {
      throw FormulaError(set->offset,
                         described(set->type) + " where a set was expected: a " +
                             std::string(wanted == types::truth ? "quantifier" : "sum, product, min or max") +
                             " runs through a set such as faces(s) or 1..k");
    }
    signature_[expression.text] = Type{set->type.name, false};
    expression.children[1] = checked(expression.children[1], wanted);
    signature_.erase(expression.text);
    expression.type = wanted;
  }

  const Vocabulary& vocabulary_;
  Signature signature_;
};

void collect(const Expression& expression, std::set<std::string>& names, std::vector<std::string>& variables) {
  if (expression.operation == Operation::name &&
      std::find(variables.begin(), variables.end(), expression.text) == variables.end()) {
    names.insert(expression.text);
  }
  const bool binds = binds_variable(expression.operation);
  for (std::size_t at = 0; at < expression.children.size(); ++at) {
    const bool in_scope = binds && at == 1;
    if (in_scope) variables.push_back(expression.text);
    collect(*expression.children[at], names, variables);
    if (in_scope) variables.pop_back();
  }
}

}  // namespace

ExpressionPointer type_checked(const ExpressionPointer& expression, const Vocabulary& vocabulary,
                               const Signature& signature, const Type& expected) {
  return Checker(vocabulary, signature).checked(expression, expected);
}

ExpressionPointer type_checked(const ExpressionPointer& expression, const Vocabulary& vocabulary,
                               const Signature& signature) {
  return Checker(vocabulary, signature).checked(expression);
}

std::vector<std::string> free_names(const Expression& expression) {
  std::set<std::string> names;
  std::vector<std::string> variables;
  collect(expression, names, variables);
  return {names.begin(), names.end()};
}

}  // namespace delcert
