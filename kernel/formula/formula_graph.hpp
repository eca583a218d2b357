#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "kernel/formula/expression.hpp"

namespace delcert {

/// What a node of a graph of formulas does with its arguments.
enum class FormulaStep : unsigned char {
  constant,
  variable,
  add,
  subtract,
  negate,
  multiply,
  divide,
  power,  ///< to a whole number ≥ 2
  root,
  exponential,
  sine,
  cosine,
};

/// Formulas and their derivatives as a graph: what is the same is there once, and an argument stands before what uses
/// it. Sums with 0, products with 0 and 1 and what is made of constants alone are worked out, exactly.
class FormulaGraph {
 public:
  using Node = std::uint32_t;

  struct Data {
    FormulaStep step = FormulaStep::constant;
    Node first = 0;   ///< an argument; of a variable, which one
    Node second = 0;  ///< the other argument; of a power, the exponent
    Rational value;   ///< of a constant
  };

  /// Precondition: the formula has come from `parse_plain_formula` with these variables. Throws FormulaError for a
  /// division by a constant that is 0, and for the root of one that is not positive.
  Node add_formula(const Expression& formula, const std::vector<std::string>& variables);
  /// The partial derivative, as a formula.
  Node derivative(Node of, std::size_t variable);

  [[nodiscard]] const Data& operator[](Node node) const { return nodes_[node]; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] bool is_zero(Node node) const;
  /// Quotients and roots of the formulas: they have to be defined even where the rest does without them.
  [[nodiscard]] const std::vector<Node>& partial_nodes() const { return partial_; }

 private:
  using Key = std::tuple<FormulaStep, Node, Node>;

  Node constant(const Rational& value);
  Node made(FormulaStep step, Node first, Node second = 0);
  Node sum(Node a, Node b);
  Node difference(Node a, Node b);
  Node opposite(Node a);
  Node product(Node a, Node b);
  Node quotient(Node a, Node b);
  Node to_power(Node a, unsigned exponent);
  Node derived(Node of, std::size_t variable);
  [[nodiscard]] bool is_constant(Node node) const { return nodes_[node].step == FormulaStep::constant; }
  [[nodiscard]] bool is_one(Node node) const { return is_constant(node) && nodes_[node].value == Rational(1); }

  std::vector<Data> nodes_;
  std::map<Key, Node> known_;
  std::map<Rational, Node> constants_;
  std::map<std::pair<Node, std::size_t>, Node> derivatives_;
  std::vector<Node> partial_;
};

}  // namespace delcert
