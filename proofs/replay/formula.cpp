#include "proofs/replay/formula.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace delcert::replay {

namespace {

NodePointer make(const std::string& head, std::vector<NodePointer> parts) {
  auto result = std::make_shared<Node>();
  result->head = head;
  result->parts = std::move(parts);
  return result;
}

NodePointer make_number(const std::string& digits) {
  auto result = std::make_shared<Node>();
  result->value = Number::read(digits);
  return result;
}

/// A definition of the paper: its parameters and its body.
struct Definition {
  std::vector<std::string> parameters;
  std::string body;
};

/// docs/claim-format.md, "Functions".
const std::map<std::string, Definition>& definitions() {
  static const std::map<std::string, Definition> all{
      {"constant_c", {{"m", "mu0"}, "m^(3/2)*(2/mu0)^(4*m^2 + 5*m + 21)"}},
      {"constant_c_tilde", {{"m", "mu0"}, "m^(3/2)*(2/mu0)^(5*m^2 + 5*m + 21)"}},
      {"flake_parameter", {{"m", "mu0", "rho0"}, "rho0/(m^(3/2)*(2/mu0)^(4*m^2 + 5*m + 21))"}},
      {"hoop_bound", {{"gamma0", "mu0"}, "2^13*gamma0/mu0^3"}},
      {"hoop_bound_tilde", {{"m", "gamma0", "mu0"}, "2^16*m^(3/2)*gamma0/mu0^3"}}};
  return all;
}

/// The operators that join two operands, by how tightly they bind; each level from left to right.
constexpr std::array<std::array<const char*, 2>, 4> joined_from_the_left{
    {{"or", "or"}, {"and", "and"}, {"+", "-"}, {"*", "/"}}};

/// One pass over the text by precedence: implies, or, and, not, comparisons, sums, products, signs, powers.
class FormulaText {
 public:
  explicit FormulaText(const std::string& text) : text_(text) { advance(); }

  NodePointer whole() {
    NodePointer result = statement();
    if (!word_.empty()) fail();
    return result;
  }

 private:
  [[noreturn]] void fail() const {
    throw Malformed("the formula \"" + text_ + "\" cannot be read at \"" + word_ + "\"");
  }

  void advance() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    const std::size_t begin = at_;
    const auto while_of = [this](const auto& belongs) {
      while (at_ < text_.size() && belongs(static_cast<unsigned char>(text_[at_]))) ++at_;
    };
    if (at_ < text_.size()) {
      const auto first = static_cast<unsigned char>(text_[at_]);
      if (std::isdigit(first) != 0) {
        while_of([](unsigned char c) { return std::isdigit(c) != 0; });
      } else if (std::isalpha(first) != 0 || first == '_') {
        while_of([](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
      } else {
        const bool has_two = text_.compare(at_, 2, "<=") == 0 || text_.compare(at_, 2, ">=") == 0;
        at_ += has_two ? 2U : 1U;
      }
    }
    word_ = text_.substr(begin, at_ - begin);
  }

  bool take(const std::string& word) {
    if (word_ != word) return false;
    advance();
    return true;
  }

  void expect(const std::string& word) {
    if (!take(word)) fail();
  }

  NodePointer statement() {
    if (++depth_ > 500) throw Malformed("a formula that is too deep");
    NodePointer left = chain(0);
    if (take("implies")) left = make("implies", {left, statement()});
    --depth_;
    return left;
  }

  NodePointer chain(std::size_t level) {
    const auto& [one, other] = joined_from_the_left[level];
    NodePointer left = operand(level);
    while (word_ == one || word_ == other) {
      const std::string head = word_;
      advance();
      left = make(head, {left, operand(level)});
    }
    return left;
  }

  NodePointer operand(std::size_t level) {
    if (level == 0) return chain(1);
    if (level == 1) return negated();
    return level == 2 ? chain(3) : signed_power();
  }

  NodePointer negated() {
    if (!take("not")) return comparisons();
    if (++depth_ > 500) throw Malformed("a formula that is too deep");
    NodePointer result = make("not", {negated()});
    --depth_;
    return result;
  }

  /// a < b <= c is a < b and b <= c.
  NodePointer comparisons() {
    NodePointer left = chain(2);
    NodePointer result;
    while (word_ == "<" || word_ == "<=" || word_ == ">" || word_ == ">=" || word_ == "=") {
      const std::string relation = word_;
      advance();
      const NodePointer right = chain(2);
      const NodePointer comparison = make(relation, {left, right});
      result = result ? make("and", {result, comparison}) : comparison;
      left = right;
    }
    return result ? result : left;
  }

  NodePointer signed_power() {
    if (++depth_ > 500) throw Malformed("a formula that is too deep");
    NodePointer result;
    if (take("-")) {
      result = make("-", {signed_power()});
    } else {
      result = atom();
      if (take("^")) result = make("^", {result, signed_power()});
    }
    --depth_;
    return result;
  }

  NodePointer atom() {
    if (take("(")) {
      NodePointer result = statement();
      expect(")");
      return result;
    }
    if (word_.empty()) fail();
    const auto first = static_cast<unsigned char>(word_[0]);
    const std::string word = word_;
    if (std::isdigit(first) != 0) {
      advance();
      return make_number(word);
    }
    static const std::array<const char*, 7> keywords{"and", "or", "not", "implies", "forall", "exists", "in"};
    const bool is_name = (std::isalpha(first) != 0 || first == '_') &&
                         std::find(keywords.begin(), keywords.end(), word) == keywords.end();
    if (!is_name) fail();
    advance();
    if (!take("(")) return make(word, {});
    std::vector<NodePointer> arguments{statement()};
    while (take(",")) arguments.push_back(statement());
    expect(")");
    return call(word, std::move(arguments));
  }

  static NodePointer call(const std::string& name, std::vector<NodePointer> arguments) {
    const auto defined = definitions().find(name);
    if (defined != definitions().end()) {
      const Definition& definition = defined->second;
      if (arguments.size() != definition.parameters.size()) throw Malformed(name + " has another number of arguments");
      Meanings meanings;
      for (std::size_t i = 0; i < arguments.size(); ++i) meanings[definition.parameters[i]] = arguments[i];
      return with_meanings(read_formula(definition.body), meanings);
    }
    const bool has_one = name == "sqrt" || name == "abs" || name == "log2";
    const bool has_many = name == "min" || name == "max";
    if (!(has_one && arguments.size() == 1) && !(has_many && arguments.size() >= 2)) {
      throw Malformed("no function of steps with so many arguments: " + name);
    }
    return make(name, std::move(arguments));
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::string word_;
  std::size_t depth_ = 0;
};

}  // namespace

NodePointer read_formula(const std::string& text) { return FormulaText(text).whole(); }

NodePointer with_meanings(const NodePointer& formula, const Meanings& meanings) {
  if (formula->is_number()) return formula;
  if (formula->is_name()) {
    const auto found = meanings.find(formula->head);
    return found == meanings.end() ? formula : found->second;
  }
  std::vector<NodePointer> parts;
  for (const NodePointer& part : formula->parts) parts.push_back(with_meanings(part, meanings));
  return make(formula->head, std::move(parts));
}

NodePointer formula_of(const Number& value) {
  if (value.sign() < 0) return make("-", {formula_of(Number(0) - value)});
  const std::string text = value.text();
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return make_number(text);
  return make("/", {make_number(text.substr(0, slash)), make_number(text.substr(slash + 1))});
}

}  // namespace delcert::replay
