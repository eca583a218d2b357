#include "proofs/formal/terms.hpp"

#include <utility>

namespace delcert {

ExpressionPointer with_children(const ExpressionPointer& node, std::vector<ExpressionPointer> children) {
  if (children == node->children) return node;
  auto result = std::make_shared<Expression>(*node);
  result->children = std::move(children);
  return result;
}

ExpressionPointer name_term(const std::string& name) {
  auto result = std::make_shared<Expression>();
  result->operation = Operation::name;
  result->text = name;
  result->type = types::number;
  return result;
}

ExpressionPointer number_term(const Rational& value) {
  auto result = std::make_shared<Expression>();
  result->operation = Operation::literal;
  result->value = value;
  result->type = types::number;
  return result;
}

ExpressionPointer binary_term(Operation operation, ExpressionPointer a, ExpressionPointer b) {
  auto result = std::make_shared<Expression>();
  result->operation = operation;
  result->children = {std::move(a), std::move(b)};
  result->type = types::number;
  return result;
}

ExpressionPointer power_term(ExpressionPointer base, long exponent) {
  return binary_term(Operation::power, std::move(base), number_term(Rational(exponent)));
}

}  // namespace delcert
