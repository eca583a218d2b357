#include "proofs/formula/type_check.hpp"

#include <algorithm>
#include <set>

#include "proofs/formula/formula_error.hpp"

namespace delcert {

namespace {

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
      throw FormulaError(expression->offset,
                         "a " + result->type.text() + " where a " + wanted.text() + " was expected");
    }
    return result;
  }

 private:
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
        if (!is_made_of_integers(*result->children[1])) {
          throw FormulaError(result->children[1]->offset, "an exponent must be made of integers and halves of them");
        }
        // So that an exponent can be 4*m^2.
        result->type =
            result->children[0]->type == types::integer && result->children[1]->operation == Operation::literal
                ? types::integer
                : types::number;
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
    }
    return result;
  }

  void check_children(Expression& expression, const Type& wanted) {
    for (auto& child : expression.children) child = checked(child, wanted);
  }

  static bool all_integers(const Expression& expression) {
    return std::all_of(expression.children.begin(), expression.children.end(),
                       [](const auto& child) { return child->type == types::integer; });
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
    if (vocabulary_.function(expression.text) != nullptr) {
      throw FormulaError(expression.offset, expression.text + " is a function: its arguments are missing");
    }
    std::string all;
    for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
    throw FormulaError(expression.offset, "nothing here is called " + expression.text +
                                              suggestion(expression.text, known) + " (there are " + all + ")");
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
          throw FormulaError(expression.children[at]->offset, "a number where an integer was expected");
        }
      }
      expression.type = types::number;
      return;
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
        throw FormulaError(child->offset, expression.text + " wants a " + wanted.text() + " as argument " +
                                              std::to_string(at + 1) + ", not a " + child->type.text());
      }
    }
    expression.type = expression.function->result;
  }

  static void require_count(const Expression& expression, std::size_t wanted, bool is_variadic) {
    const std::size_t given = expression.children.size();
    if (is_variadic ? given >= 2 : given == wanted) return;
    throw FormulaError(expression.offset, expression.text + " wants " +
                                              (is_variadic ? "two or more" : std::to_string(wanted)) +
                                              " arguments, not " + std::to_string(given));
  }

  void check_quantifier(Expression& expression) {
    if (signature_.contains(expression.text)) {
      throw FormulaError(expression.offset, "the variable " + expression.text + " is already something else");
    }
    auto& set = expression.children[0];
    set = checked(set);
    if (!set->type.is_set) {
      throw FormulaError(set->offset, "a " + set->type.text() + " where a set was expected: a quantifier runs " +
                                          "through a set such as vertices(s) or 1..k");
    }
    signature_[expression.text] = Type{set->type.name, false};
    expression.children[1] = checked(expression.children[1], types::truth);
    signature_.erase(expression.text);
    expression.type = types::truth;
  }

  const Vocabulary& vocabulary_;
  Signature signature_;
};

void collect(const Expression& expression, std::set<std::string>& names, std::vector<std::string>& variables) {
  if (expression.operation == Operation::name &&
      std::find(variables.begin(), variables.end(), expression.text) == variables.end()) {
    names.insert(expression.text);
  }
  const bool binds = expression.operation == Operation::for_all || expression.operation == Operation::exists;
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

std::vector<std::string> free_names(const Expression& expression) {
  std::set<std::string> names;
  std::vector<std::string> variables;
  collect(expression, names, variables);
  return {names.begin(), names.end()};
}

}  // namespace delcert
