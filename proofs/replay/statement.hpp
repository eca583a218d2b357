#pragma once

#include <memory>
#include <string>
#include <vector>

#include "proofs/replay/number.hpp"

namespace delcert::replay {

/// A term or a statement: a number, a name, or an operator with what it is applied to.
struct Node {
  std::string head;  ///< the operator or the name; empty for a number
  Number value;
  std::vector<std::shared_ptr<const Node>> parts;

  bool is_number() const { return head.empty(); }
  bool is_name() const { return !head.empty() && parts.empty(); }
  bool is_comparison() const { return head == "<" || head == "<=" || head == ">" || head == ">=" || head == "="; }
};

using NodePointer = std::shared_ptr<const Node>;

/// Reads an S-expression such as (<= (* x (- 1 x)) (/ 1 4)). Throws Malformed.
NodePointer read_statement(const std::string& text);

/// The S-expression again.
std::string text_of(const Node& node);

/// The statements which together say that the hypotheses imply the claim (docs/prover.md, "Goals").
std::vector<NodePointer> goals_of(const std::vector<NodePointer>& hypotheses, const NodePointer& claim);

/// The comparisons of a statement from left to right.
std::vector<const Node*> comparisons_of(const Node& statement);

/// Three values: −1 refuted, 0 unknown, 1 proved.
int truth_of(const Node& statement, const std::vector<int>& comparisons);

}  // namespace delcert::replay
