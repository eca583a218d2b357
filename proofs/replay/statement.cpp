#include "proofs/replay/statement.hpp"

#include <algorithm>
#include <cctype>
#include <map>

namespace delcert::replay {

namespace {

/// The least and the greatest number of parts of each operator.
const std::map<std::string, std::pair<std::size_t, std::size_t>> operators{
    {"+", {2, 2}},   {"-", {1, 2}},    {"*", {2, 2}},      {"/", {2, 2}},       {"^", {2, 2}},
    {"<", {2, 2}},   {"<=", {2, 2}},   {">", {2, 2}},      {">=", {2, 2}},      {"=", {2, 2}},
    {"not", {1, 1}}, {"and", {2, 2}},  {"or", {2, 2}},     {"implies", {2, 2}}, {"sqrt", {1, 1}},
    {"abs", {1, 1}}, {"log2", {1, 1}}, {"min", {2, 1000}}, {"max", {2, 1000}}};

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  NodePointer whole() {
    NodePointer result = node(0);
    if (at_ != text_.size()) throw Malformed("text after a statement: " + text_.substr(at_, 20));
    return result;
  }

 private:
  std::string word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != ' ' && text_[at_] != '(' && text_[at_] != ')') ++at_;
    if (at_ == begin) throw Malformed("a statement that ends too early");
    return text_.substr(begin, at_ - begin);
  }

  NodePointer node(std::size_t depth) {
    if (depth > 5000) throw Malformed("a statement that is too deep");
    auto result = std::make_shared<Node>();
    if (at_ < text_.size() && text_[at_] == '(') {
      ++at_;
      result->head = word();
      while (at_ < text_.size() && text_[at_] == ' ') {
        ++at_;
        result->parts.push_back(node(depth + 1));
      }
      if (at_ == text_.size() || text_[at_] != ')') throw Malformed("a statement without its closing parenthesis");
      ++at_;
      const auto known = operators.find(result->head);
      if (known == operators.end() || result->parts.size() < known->second.first ||
          result->parts.size() > known->second.second) {
        throw Malformed("no operator of so many parts: " + result->head);
      }
      return result;
    }
    const std::string leaf = word();
    if (std::isdigit(static_cast<unsigned char>(leaf[0])) != 0) {
      result->value = Number::read(leaf);
    } else {
      result->head = leaf;
    }
    return result;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

NodePointer apply(const std::string& head, std::vector<NodePointer> parts) {
  auto result = std::make_shared<Node>();
  result->head = head;
  result->parts = std::move(parts);
  return result;
}

bool can_lack_a_value(const Node& term) {
  if (term.head == "/" || term.head == "^" || term.head == "sqrt" || term.head == "log2") return true;
  return std::any_of(term.parts.begin(), term.parts.end(),
                     [](const NodePointer& part) { return can_lack_a_value(*part); });
}

NodePointer joined(const std::string& head, const std::vector<NodePointer>& parts) {
  NodePointer result = parts.at(0);
  for (std::size_t i = 1; i < parts.size(); ++i) result = apply(head, {result, parts[i]});
  return result;
}

/// On either side of a comparison, greatest and least terms and absolute values become several comparisons.
NodePointer without_extremes(const NodePointer& comparison) {
  if (comparison->head == "=") return comparison;
  for (std::size_t side = 0; side < 2; ++side) {
    const NodePointer& term = comparison->parts[side];
    std::vector<NodePointer> choices;
    if (term->head == "max" || term->head == "min") choices = term->parts;
    if (term->head == "abs") choices = {term->parts[0], apply("-", {term->parts[0]})};
    if (choices.empty()) continue;
    const bool term_is_smaller = (comparison->head[0] == '<') == (side == 0);
    const bool every = term_is_smaller == (term->head != "min");
    std::vector<NodePointer> parts;
    for (const NodePointer& choice : choices) {
      auto sides = comparison->parts;
      sides[side] = choice;
      parts.push_back(without_extremes(apply(comparison->head, sides)));
    }
    NodePointer result = joined(every ? "and" : "or", parts);
    if (every) return result;
    for (const NodePointer& choice : choices) {
      if (can_lack_a_value(*choice)) result = apply("and", {apply("=", {choice, choice}), result});
    }
    return result;
  }
  return comparison;
}

NodePointer prepared(const NodePointer& statement) {
  if (statement->is_comparison()) return without_extremes(statement);
  std::vector<NodePointer> parts;
  for (const NodePointer& part : statement->parts) parts.push_back(prepared(part));
  return apply(statement->head, parts);
}

void take_apart(const std::vector<NodePointer>& hypotheses, const NodePointer& claim, std::vector<NodePointer>& goals) {
  if (claim->head == "and") {
    for (const NodePointer& part : claim->parts) take_apart(hypotheses, part, goals);
  } else if (claim->head == "implies") {
    std::vector<NodePointer> more = hypotheses;
    more.push_back(claim->parts[0]);
    take_apart(more, claim->parts[1], goals);
  } else {
    NodePointer goal = claim;
    for (std::size_t i = hypotheses.size(); i-- > 0;) goal = apply("implies", {hypotheses[i], goal});
    goals.push_back(goal);
  }
}

void collect(const Node& statement, std::vector<const Node*>& found) {
  if (statement.is_comparison()) {
    found.push_back(&statement);
    return;
  }
  const bool joins =
      statement.head == "and" || statement.head == "or" || statement.head == "implies" || statement.head == "not";
  if (!joins) throw Malformed("a term where a statement was expected: " + text_of(statement));
  for (const NodePointer& part : statement.parts) collect(*part, found);
}

int truth_from(const Node& statement, const std::vector<int>& comparisons, std::size_t& next) {
  if (statement.is_comparison()) return comparisons.at(next++);
  const int first = truth_from(*statement.parts[0], comparisons, next);
  if (statement.head == "not") return -first;
  const int second = truth_from(*statement.parts[1], comparisons, next);
  if (statement.head == "and") return std::min(first, second);
  return std::max(statement.head == "or" ? first : -first, second);
}

}  // namespace

NodePointer read_statement(const std::string& text) { return Reader(text).whole(); }

std::string text_of(const Node& node) {
  if (node.is_number()) return node.value.text();
  if (node.is_name()) return node.head;
  std::string result = "(" + node.head;
  for (const NodePointer& part : node.parts) result += " " + text_of(*part);
  return result + ")";
}

std::vector<NodePointer> goals_of(const std::vector<NodePointer>& hypotheses, const NodePointer& claim) {
  std::vector<NodePointer> ready;
  for (const NodePointer& hypothesis : hypotheses) ready.push_back(prepared(hypothesis));
  std::vector<NodePointer> goals;
  take_apart(ready, prepared(claim), goals);
  return goals;
}

std::vector<const Node*> comparisons_of(const Node& statement) {
  std::vector<const Node*> found;
  collect(statement, found);
  return found;
}

int truth_of(const Node& statement, const std::vector<int>& comparisons) {
  std::size_t next = 0;
  return truth_from(statement, comparisons, next);
}

}  // namespace delcert::replay
