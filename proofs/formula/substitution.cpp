#include "proofs/formula/substitution.hpp"

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

namespace {

/// The node with other children; the node itself if none has changed.
ExpressionPointer rebuilt_with(const ExpressionPointer& node, std::vector<ExpressionPointer> children) {
  if (children == node->children) return node;
  auto result = std::make_shared<Expression>(*node);
  result->children = std::move(children);
  return result;
}

ExpressionPointer literal(const Integer& value) {
  auto result = std::make_shared<Expression>();
  result->value = Rational(value);
  result->type = types::integer;
  return result;
}

}  // namespace

ExpressionPointer replaced(const ExpressionPointer& formula, const Replacements& replacements) {
  if (formula->operation == Operation::name) {
    const auto found = replacements.find(formula->text);
    return found == replacements.end() ? formula : found->second;
  }
  const bool binds = binds_variable(formula->operation);
  std::vector<ExpressionPointer> children;
  for (const auto& child : formula->children) {
    if (binds && !children.empty()) {
      Replacements inside = replacements;
      inside.erase(formula->text);
      children.push_back(replaced(child, inside));
    } else {
      children.push_back(replaced(child, replacements));
    }
  }
  return rebuilt_with(formula, std::move(children));
}

ExpressionPointer without_definitions(const ExpressionPointer& formula) {
  std::vector<ExpressionPointer> children;
  for (const auto& child : formula->children) children.push_back(without_definitions(child));
  if (formula->operation == Operation::call && formula->definition != nullptr) {
    Replacements arguments;
    for (std::size_t at = 0; at < children.size(); ++at) {
      arguments[formula->definition->parameters[at]] = children[at];
    }
    return replaced(without_definitions(formula->definition->body), arguments);
  }
  return rebuilt_with(formula, std::move(children));
}

ExpressionPointer less_base(const ExpressionPointer& statement, const ExpressionPointer& base) {
  std::vector<ExpressionPointer> children = statement->children;
  for (auto& child : children) {
    if (is_comparison(statement->operation)) {
      auto difference = std::make_shared<Expression>();
      difference->operation = Operation::subtract;
      difference->type = types::number;
      difference->children = {child, base};
      child = difference;
    } else if (child->type == types::truth) {
      child = less_base(child, base);
    }
  }
  return rebuilt_with(statement, std::move(children));
}

ExpressionPointer number_expression(const Rational& value) {
  if (value < Rational(0)) {
    auto result = std::make_shared<Expression>();
    result->operation = Operation::negate;
    result->children = {number_expression(-value)};
    result->type = result->children[0]->type;
    return result;
  }
  if (value.denominator() == 1) return literal(value.numerator());
  auto result = std::make_shared<Expression>();
  result->operation = Operation::divide;
  result->children = {literal(value.numerator()), literal(value.denominator())};
  result->type = types::number;
  return result;
}

}  // namespace delcert
