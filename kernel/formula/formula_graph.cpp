#include "kernel/formula/formula_graph.hpp"

#include <algorithm>
#include <utility>

#include "kernel/formula/formula_error.hpp"

namespace delcert {

namespace {

FormulaStep step_of(const std::string& function) {
  if (function == "sqrt") return FormulaStep::root;
  if (function == "exp") return FormulaStep::exponential;
  return function == "sin" ? FormulaStep::sine : FormulaStep::cosine;
}

}  // namespace

bool FormulaGraph::is_zero(Node node) const { return is_constant(node) && nodes_[node].value == Rational(0); }

FormulaGraph::Node FormulaGraph::constant(const Rational& value) {
  const auto [place, is_new] = constants_.try_emplace(value, static_cast<Node>(nodes_.size()));
  if (is_new) nodes_.push_back({FormulaStep::constant, 0, 0, value});
  return place->second;
}

FormulaGraph::Node FormulaGraph::made(FormulaStep step, Node first, Node second) {
  const auto [place, is_new] = known_.try_emplace({step, first, second}, static_cast<Node>(nodes_.size()));
  if (is_new) nodes_.push_back({step, first, second, Rational()});
  return place->second;
}

FormulaGraph::Node FormulaGraph::sum(Node a, Node b) {
  if (is_constant(a) && is_constant(b)) return constant(nodes_[a].value + nodes_[b].value);
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  if (nodes_[b].step == FormulaStep::negate) return difference(a, nodes_[b].first);
  if (a == b) return product(constant(Rational(2)), a);
  return made(FormulaStep::add, std::min(a, b), std::max(a, b));
}

FormulaGraph::Node FormulaGraph::difference(Node a, Node b) {
  if (a == b) return constant(Rational(0));
  if (is_constant(a) && is_constant(b)) return constant(nodes_[a].value - nodes_[b].value);
  if (is_zero(a)) return opposite(b);
  if (is_zero(b)) return a;
  if (nodes_[b].step == FormulaStep::negate) return sum(a, nodes_[b].first);
  return made(FormulaStep::subtract, a, b);
}

FormulaGraph::Node FormulaGraph::opposite(Node a) {
  if (is_constant(a)) return constant(-nodes_[a].value);
  if (nodes_[a].step == FormulaStep::negate) return nodes_[a].first;
  return made(FormulaStep::negate, a);
}

FormulaGraph::Node FormulaGraph::product(Node a, Node b) {
  if (is_constant(b)) std::swap(a, b);
  if (is_constant(a)) {
    if (is_constant(b)) return constant(nodes_[a].value * nodes_[b].value);
    if (is_zero(a)) return a;
    if (is_one(a)) return b;
    if (nodes_[a].value == Rational(-1)) return opposite(b);
    const Data other = nodes_[b];
    if (other.step == FormulaStep::negate) return product(constant(-nodes_[a].value), other.first);
    // A constant factor stands in front, once, and first among the arguments.
    if (other.step == FormulaStep::multiply && is_constant(other.first))
      return product(constant(nodes_[a].value * nodes_[other.first].value), other.second);
    return made(FormulaStep::multiply, a, b);
  }
  for (const auto& [one, rest] : {std::pair{a, b}, std::pair{b, a}}) {
    const Data data = nodes_[one];
    if (data.step == FormulaStep::negate) return opposite(product(data.first, rest));
    if (data.step == FormulaStep::multiply && is_constant(data.first))
      return product(data.first, product(data.second, rest));
  }
  if (a == b) return to_power(a, 2);
  return made(FormulaStep::multiply, std::min(a, b), std::max(a, b));
}

FormulaGraph::Node FormulaGraph::quotient(Node a, Node b) {
  if (is_constant(b)) return product(constant(Rational(1) / nodes_[b].value), a);
  if (is_zero(a)) return a;
  return made(FormulaStep::divide, a, b);
}

FormulaGraph::Node FormulaGraph::to_power(Node a, unsigned exponent) {
  if (exponent == 0) return constant(Rational(1));
  if (exponent == 1) return a;
  if (is_constant(a)) return constant(power(nodes_[a].value, static_cast<long>(exponent)));
  if (nodes_[a].step == FormulaStep::negate) {
    const Node result = to_power(nodes_[a].first, exponent);
    return exponent % 2 == 0 ? result : opposite(result);
  }
  return made(FormulaStep::power, a, exponent);
}

FormulaGraph::Node FormulaGraph::add_formula(const Expression& formula, const std::vector<std::string>& variables) {
  std::vector<Node> arguments;
  for (const ExpressionPointer& child : formula.children) arguments.push_back(add_formula(*child, variables));
  switch (formula.operation) {
    case Operation::literal:
      return constant(formula.value);
    case Operation::name:
      return made(FormulaStep::variable,
                  static_cast<Node>(std::find(variables.begin(), variables.end(), formula.text) - variables.begin()));
    case Operation::negate:
      return opposite(arguments[0]);
    case Operation::add:
      return sum(arguments[0], arguments[1]);
    case Operation::subtract:
      return difference(arguments[0], arguments[1]);
    case Operation::multiply:
      return product(arguments[0], arguments[1]);
    case Operation::power:
      return to_power(arguments[0], formula.children[1]->value.numerator().convert_to<unsigned>());
    case Operation::divide: {
      if (is_zero(arguments[1])) throw FormulaError(formula.offset, "a division by 0");
      const bool is_partial = !is_constant(arguments[1]);
      // A quotient of 0 has to be defined, too.
      if (is_partial) partial_.push_back(made(FormulaStep::divide, constant(Rational(1)), arguments[1]));
      const Node result = quotient(arguments[0], arguments[1]);
      if (is_partial && nodes_[result].step == FormulaStep::divide) partial_.back() = result;
      return result;
    }
    default: {
      const FormulaStep step = step_of(formula.text);
      if (step == FormulaStep::root && is_constant(arguments[0]) && nodes_[arguments[0]].value <= Rational(0))
        throw FormulaError(formula.offset, "the root of a number that is not positive");
      const Node result = made(step, arguments[0]);
      if (step == FormulaStep::root) partial_.push_back(result);
      return result;
    }
  }
}

FormulaGraph::Node FormulaGraph::derivative(Node of, std::size_t variable) {
  const auto found = derivatives_.find({of, variable});
  if (found != derivatives_.end()) return found->second;
  const Node result = derived(of, variable);
  derivatives_.emplace(std::pair{of, variable}, result);
  return result;
}

FormulaGraph::Node FormulaGraph::derived(Node of, std::size_t variable) {
  const Data data = nodes_[of];
  if (data.step == FormulaStep::constant) return constant(Rational(0));
  if (data.step == FormulaStep::variable) return constant(Rational(data.first == variable ? 1 : 0));
  const Node first = derivative(data.first, variable);
  switch (data.step) {
    case FormulaStep::add:
      return sum(first, derivative(data.second, variable));
    case FormulaStep::subtract:
      return difference(first, derivative(data.second, variable));
    case FormulaStep::negate:
      return opposite(first);
    case FormulaStep::multiply:
      return sum(product(first, data.second), product(data.first, derivative(data.second, variable)));
    case FormulaStep::divide:
      return quotient(difference(first, product(of, derivative(data.second, variable))), data.second);
    case FormulaStep::power:
      return product(product(constant(Rational(data.second)), to_power(data.first, data.second - 1)), first);
    case FormulaStep::root:
      return quotient(first, product(constant(Rational(2)), of));
    case FormulaStep::exponential:
      return product(of, first);
    case FormulaStep::sine:
      return product(made(FormulaStep::cosine, data.first), first);
    default:
      return opposite(product(made(FormulaStep::sine, data.first), first));
  }
}

}  // namespace delcert
